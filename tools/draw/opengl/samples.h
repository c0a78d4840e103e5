// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/opengl/program.h"

namespace clipc::draw {

// Makes the texture that is bound to `target`, GL_TEXTURE_2D_MULTISAMPLE or its array, one whose
// samples have the texels of `level`: the texels of sample 0 come first, layer after layer. OpenGL
// has no call that writes a sample, so each is drawn from a plain texture. Requires OpenGL 3.2 or
// OpenGL ES 3.1, for an array 3.2.
void UploadSamples(GLenum target, GLenum internal, GLenum components, GLenum type, WordKind kind,
                   const Inputs::Texture::Level& level);

}  // namespace clipc::draw
