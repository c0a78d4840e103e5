// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include <epoxy/gl.h>

#include "base/not_copied.h"
#include "tools/harness/image.h"

namespace clipc::harness {

struct FramebufferFormat {
  GLenum color = GL_RGBA8;
  GLenum depth = GL_NONE;  // GL_NONE: no depth buffer
  int samples = 1;         // of each pixel
};

// A framebuffer in place of a window. It is bound, with its viewport set, when it is made. Throws
// DrawError where the current context does not support the format.
class Framebuffer : NotCopied {
 public:
  Framebuffer(int width, int height, const FramebufferFormat& format = {});
  ~Framebuffer();

  // Makes the framebuffer the target of draws, over the whole of it.
  void Bind() const;
  // Copies the colors of `other`, which has the same size, as the mean of each pixel's samples.
  // Binds this framebuffer.
  void Resolve(const Framebuffer& other) const;

  // The colors with the top row first. This framebuffer must be bound, also for the functions
  // below; they throw DrawError when OpenGL has noted an error.
  Image Read() const;
  // The colors with the bottom row first, for an image that was drawn upside down.
  Image ReadUpsideDown() const;
  // The values of `components`, GL_RED or GL_RGBA, as floats with the bottom row first.
  std::vector<float> ReadFloats(GLenum components) const;

 private:
  int width_, height_;
  GLuint framebuffer_ = 0, color_ = 0, depth_ = 0;
};

// A framebuffer for images, with a depth test.
class Canvas : public Framebuffer {
 public:
  Canvas(int width, int height) : Framebuffer(width, height, {.depth = GL_DEPTH_COMPONENT24}) {
    glEnable(GL_DEPTH_TEST);
  }
};

}  // namespace clipc::harness
