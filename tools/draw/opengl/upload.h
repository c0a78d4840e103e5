// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>

#include "tools/draw/inputs.h"

namespace clipc::draw {

// Makes a texture that samples the nearest texel and binds it to the active texture unit.
// `new_buffer` makes the buffer that a GL_TEXTURE_BUFFER reads.
GLuint UploadTexture(const Inputs::Texture& texture,
                     const std::function<GLuint(const Words& words)>& new_buffer);

}  // namespace clipc::draw
