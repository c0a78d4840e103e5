// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "backend-glsl/write.h"
#include "backend-spirv/write.h"
#include "compiler/compile/validate.h"

namespace clipc {

// Writes SPIR-V of a program that is lowered for Vulkan, with the names and places of its GLSL, but
// without the lines of the source; what else the writer lacks, it says.
spirv::Written WriteSpirv(const ir::Program& program, const glsl::GlslInfo& info,
                          const glsl::WriteOptions& options, const SpirvRequest& request);

}  // namespace clipc
