// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "backend-glsl/write.h"
#include "backend-spirv/write.h"
#include "base/diagnostics.h"
#include "compiler/compile/spirv_request.h"
#include "frontend/lex/source.h"

namespace clipc {

// What the target's SPIR-V needs of the legalising passes.
legalize::Needs SpirvNeeds(const glsl::Target& target);

// Reports what the program has and the SPIR-V that is asked for lacks. Requires that CheckTarget
// has reported no error.
void CheckSpirv(const ir::Program& program, const glsl::Target& target, const SpirvRequest& request,
                Diagnostics& diagnostics);

// Writes SPIR-V of a program that is lowered for the target, Vulkan or OpenGL, with the names and
// places of its GLSL; what the writer lacks, it says. `source`, whose main file has that path, is
// for debug information only.
spirv::Written WriteSpirv(const ir::Program& program, const glsl::GlslInfo& info,
                          const glsl::Target& target, const glsl::WriteOptions& options,
                          const SpirvRequest& request, const Source* source = nullptr,
                          std::string_view path = {});

}  // namespace clipc
