// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/harness/framebuffer.h"

#include <algorithm>
#include <cstddef>

#include "tools/harness/offscreen.h"

namespace clipc::harness {

Framebuffer::Framebuffer(int width, int height, const FramebufferFormat& format)
    : width_(width), height_(height) {
  const auto attach = [&](GLenum place, GLenum buffer_format) {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    // A single sample for each pixel is requested as 0 samples.
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, format.samples == 1 ? 0 : format.samples,
                                     buffer_format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
    return buffer;
  };
  glGenFramebuffers(1, &framebuffer_);
  Bind();
  color_ = attach(GL_COLOR_ATTACHMENT0, format.color);
  if (format.depth != GL_NONE) depth_ = attach(GL_DEPTH_ATTACHMENT, format.depth);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw DrawError("OpenGL has no such framebuffer");
}

Framebuffer::~Framebuffer() {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteRenderbuffers(1, &color_);
  glDeleteRenderbuffers(1, &depth_);
}

void Framebuffer::Bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, width_, height_);
}

void Framebuffer::Resolve(const Framebuffer& other) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, other.framebuffer_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  Bind();
}

Image Framebuffer::ReadUpsideDown() const {
  Image image{width_, height_, {}};
  image.rgba.resize(std::size_t{4} * static_cast<std::size_t>(width_ * height_));
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  CheckErrors("reading the image");
  return image;
}

Image Framebuffer::Read() const {
  Image image = ReadUpsideDown();
  const std::ptrdiff_t row = std::ptrdiff_t{4} * width_;
  for (int top = 0, bottom = height_ - 1; top < bottom; ++top, --bottom) {
    const auto first = image.rgba.begin() + top * row;
    std::swap_ranges(first, first + row, image.rgba.begin() + bottom * row);
  }
  return image;
}

std::vector<float> Framebuffer::ReadFloats(GLenum components) const {
  std::vector<float> floats(static_cast<std::size_t>(width_) * height_ *
                            (components == GL_RED ? 1 : 4));
  glReadPixels(0, 0, width_, height_, components, GL_FLOAT, floats.data());
  CheckErrors("reading the image");
  return floats;
}

}  // namespace clipc::harness
