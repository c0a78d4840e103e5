// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>
#include <string>

#include "clip-table/clip_table.h"
#include "compiler/count_matrices.h"
#include "compiler/stages.h"

namespace clipc {

// The text of --reflect, a JSON document with everything that the host needs to feed the shader:
// inputs and outputs with semantics, locations and types; constant buffers with members, offsets,
// registers and their layout in the GLSL; textures and samplers; clip planes and what to enable.
// docs/reflection.md describes every key. The pixel shader of a pair, if given, is a part of the
// document.
struct ReflectedStage {
  const Lowered& lowered;
  const glsl::GlslInfo& info;
  const clip_table::ClipTable& table;
};
std::string Reflect(const ReflectedStage& stage, const PositionMatrices& position,
                    const ReflectedStage* pixel = nullptr);
// Adds the constants that have an initial value, by name: the bytes in a buffer, in hexadecimal
// digits.
void AddInitialValues(const ir::Program& program, std::map<std::string, std::string>& to);

}  // namespace clipc
