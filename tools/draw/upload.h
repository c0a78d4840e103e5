// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "tools/draw/gl.h"
#include "tools/draw/program.h"

namespace clipc::draw {

bool IsSampler(GLenum type);

// A new texture, bound to the active texture unit; samples the nearest texel. new_buffer makes what
// GL_TEXTURE_BUFFER reads.
GLuint UploadTexture(
    const Gl& gl, const Inputs::Texture& texture,
    const std::function<GLuint(const std::vector<std::uint32_t>& words)>& new_buffer);

}  // namespace clipc::draw
