// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "tools/draw/vulkan/spirv.h"

namespace clipc::draw::reference_compiler {

struct HlslSource {
  std::string path, text, entry = "main";
  std::vector<std::string> defines, include_dirs;
  bool row_major = false;
};

// Compiles HLSL as glslangValidator -D -V --hlsl-offsets does it, and writes down the semantics.
// `legalize`: variables that are not read are left out, and the SPIR-V keeps Vulkan's rules;
// without it, all that the shader declares is there. Throws DrawError where glslang refuses the
// shader, or makes invalid SPIR-V.
vulkan::Spirv SpirvOfHlsl(const HlslSource& source, bool legalize);

}  // namespace clipc::draw::reference_compiler
