// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/opengl/program.h"

namespace clipc::draw {

// Makes the texture that is bound to GL_TEXTURE_2D_MULTISAMPLE one whose samples have the texels of
// `level`: its size is the width, the height and the number of samples, and the texels of sample 0
// come first. OpenGL has no call that writes a sample, so each is drawn from a plain texture.
// Requires OpenGL 3.2 or OpenGL ES 3.1.
void UploadSamples(GLenum internal, GLenum components, GLenum type, WordKind kind,
                   const Inputs::Texture::Level& level);

}  // namespace clipc::draw
