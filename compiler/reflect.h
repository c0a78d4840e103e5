// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "backend-glsl/target.h"
#include "backend-glsl/writer.h"
#include "clip-table/clip_table.h"
#include "ir/program.h"

namespace clipc {

// For --reflect: everything the host needs to feed the shader, as a JSON document. Inputs and
// outputs with semantics, locations and types; constant buffers with members, offsets, registers
// and how each is laid out in the GLSL; textures and samplers; clip planes and what to enable.
// docs/reflection.md describes every key.
std::string Reflect(const ir::Program& program, const glsl::Target& target,
                    const glsl::GlslInfo& info, const clip_table::ClipTable& table);

}  // namespace clipc
