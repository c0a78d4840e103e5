// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "tools/draw/gl.h"

namespace clipc::draw {

// A square framebuffer of four floats for each pixel, bound and cleared to zero while it lives.
// There is no window, so even a run without rasterisation needs one.
class Target {
 public:
  Target(const Gl& gl, int size);
  ~Target();
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  std::vector<float> Read() const;  // RGBA, the bottom row first

 private:
  const Gl& gl_;
  int size_;
  GLuint framebuffer_ = 0, color_ = 0;
};

}  // namespace clipc::draw
