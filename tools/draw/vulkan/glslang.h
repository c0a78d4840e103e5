// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "tools/draw/gl.h"
#include "tools/draw/vulkan/spirv.h"

// Vertex shaders to SPIR-V, by glslang.
namespace clipc::draw::vulkan {

// GLSL for Vulkan. What glslang refuses is a DrawError.
Spirv SpirvOfGlsl(const std::string& glsl);

struct HlslSource {
  std::string path, text, entry = "main";
  std::vector<std::string> defines, include_dirs;
  bool row_major = false;
};
// What glslang's HLSL front end refuses.
class PeerRefuses : public DrawError {
 public:
  using DrawError::DrawError;
};
// As glslangValidator -D -V --hlsl-offsets does it, with the semantics written down. legalize: what
// is not read is left out, and the SPIR-V keeps Vulkan's rules; else all that the shader declares
// is there.
Spirv SpirvOfHlsl(const HlslSource& source, bool legalize);

}  // namespace clipc::draw::vulkan
