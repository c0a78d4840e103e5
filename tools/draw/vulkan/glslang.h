// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "compiler/validate.h"
#include "tools/draw/inputs.h"
#include "tools/draw/vulkan/spirv.h"

// Shaders to SPIR-V, by glslang.
namespace clipc::draw::vulkan {

// Compiles GLSL for Vulkan. Throws DrawError where glslang refuses it.
Spirv SpirvOfGlsl(const std::string& glsl, ShaderStage stage = ShaderStage::kVertex);

struct HlslSource {
  std::string path, text, entry = "main";
  std::vector<std::string> defines, include_dirs;
  bool row_major = false;
};
// The error of a shader that glslang's HLSL front end refuses.
class PeerRefuses : public DrawError {
 public:
  using DrawError::DrawError;
};
// Compiles HLSL as glslangValidator -D -V --hlsl-offsets does it, and writes down the semantics.
// `legalize`: variables that are not read are left out, and the SPIR-V keeps Vulkan's rules;
// without it, all that the shader declares is there.
Spirv SpirvOfHlsl(const HlslSource& source, bool legalize);

}  // namespace clipc::draw::vulkan
