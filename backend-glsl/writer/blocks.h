// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "backend-glsl/writer/code.h"

namespace clipc::glsl {

struct UniformBlocks {
  std::string text;                          // the declarations
  std::vector<GlslInfo::UniformBlock> info;  // of the reached ones, in order of declaration
};
// Declares all constant buffers that are reached, as uniform blocks or plain uniforms.
UniformBlocks WriteBlocks(Code& code);

}  // namespace clipc::glsl
