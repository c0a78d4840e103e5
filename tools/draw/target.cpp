// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/target.h"

namespace clipc::draw {

Target::Target(const Gl& gl, int size) : gl_(gl), size_(size) {
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.GenRenderbuffers(1, &color_);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, color_);
  gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, size, size);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw DrawError("no framebuffer of floats");
  gl_.Viewport(0, 0, size, size);
  gl_.ClearColor(0, 0, 0, 0);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
}

Target::~Target() {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteRenderbuffers(1, &color_);
}

std::vector<float> Target::Read() const {
  std::vector<float> rgba(static_cast<std::size_t>(size_) * size_ * 4);
  gl_.ReadPixels(0, 0, size_, size_, GL_RGBA, GL_FLOAT, rgba.data());
  return rgba;
}

}  // namespace clipc::draw
