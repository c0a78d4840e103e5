// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "backend-glsl/write.h"
#include "backend-spirv/write.h"
#include "base/diagnostics.h"
#include "compiler/compile/spirv_request.h"
#include "compiler/compile/stages.h"
#include "frontend/lex/source.h"

namespace clipc {

// What the target's SPIR-V needs of the legalising passes.
legalize::Needs SpirvNeeds(const glsl::Target& target);

// Reports what the program has and the SPIR-V that is asked for lacks. Requires that CheckTarget
// has reported no error.
void CheckSpirv(const ir::Program& program, const glsl::Target& target, const SpirvRequest& request,
                Diagnostics& diagnostics);

// What debug information is made of: the text, whose main file has that path; null: there is none.
struct DebugText {
  const Source* source = nullptr;
  std::string_view path = {};
};

// Writes SPIR-V of a program that is lowered for the target, Vulkan or OpenGL, with the names and
// places of its GLSL; what the writer lacks, it says.
spirv::Written WriteSpirv(const Lowered& lowered, const glsl::GlslInfo& info,
                          const glsl::WriteOptions& options, const SpirvRequest& request,
                          const DebugText& text = {});

}  // namespace clipc
