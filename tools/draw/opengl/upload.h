// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>

#include "tools/draw/inputs.h"

namespace clipc::draw {

// Makes a texture that samples the nearest texel and binds it to the active texture unit.
// `new_buffer` makes the buffer that a GL_TEXTURE_BUFFER reads.
GLuint UploadTexture(const Inputs::Texture& texture,
                     const std::function<GLuint(const Words& words)>& new_buffer);
// Binds an image, which UploadTexture made, to a unit of images.
void BindImage(const Inputs::Texture& texture, GLuint id, GLuint unit);

}  // namespace clipc::draw
