// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tools/draw/program.h"

namespace clipc::draw {

struct PictureOptions {
  int size = 64;  // pixels in each direction
  std::uint32_t enable_mask =
      0;  // bit i: glEnable(GL_CLIP_DISTANCE0 + i), the same as GL_CLIP_PLANE0 + i
  std::map<int, std::array<double, 4>> clip_planes =
      {};                     // glClipPlane(i, ...) with an identity modelview
  bool zero_to_one = false;   // glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE)
  std::string fragment = {};  // draws red, and depth as green; empty: one that does
};

struct Pixel {
  bool drawn = false;
  float depth = 0;  // window depth: 0 near, 1 far
};

struct Picture {
  int size = 0;
  std::vector<Pixel> pixels;  // the bottom row first
  const Pixel& At(int x, int y) const { return pixels[static_cast<std::size_t>(y) * size + x]; }
};

// Draws the inputs' vertices as triangles.
Picture Draw(const Gl& gl, const std::string& vertex, const Inputs& inputs,
             const PictureOptions& options);

// The top row first; drawn pixels darken with depth. For looking at.
void WritePng(const Picture& picture, const std::string& path);

// The whole target as a mesh of triangles in Direct3D clip space: x and y from -1 to 1 after the
// division by w, depth rising from 1/4 on the left to 3/4 on the right, w from 1 at the bottom to 2
// at the top. Four floats for each vertex.
std::vector<std::array<float, 4>> FullTarget();
inline constexpr float DepthAt(float x) { return 0.5f + 0.25f * x; }

// What a picture of FullTarget must show.
struct Expectation {
  std::vector<std::array<double, 4>>
      planes;            // a pixel is drawn where all are >= 0 at (x, y, DepthAt(x), 1)
  bool flipped = false;  // upside down
};
struct Difference {
  int drawn = 0, missing = 0,
      extra = 0;           // pixels; those nearer than 1/20 pixel to a plane's edge count as right
  double depth_error = 0;  // the largest, of pixels that are rightly drawn
};
Difference Compare(const Picture& picture, const Expectation& expectation);

}  // namespace clipc::draw
