// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tools/draw/inputs.h"
#include "tools/harness/image.h"

namespace clipc::draw {

struct ImageOptions {
  int size = 64;  // pixels in each direction
  // Bit i: glEnable(GL_CLIP_DISTANCE0 + i), which is the same as GL_CLIP_PLANE0 + i.
  std::uint32_t enable_mask = 0;
  // glClipPlane(i, ...) with an identity modelview; in the compatibility profile.
  std::map<int, std::array<double, 4>> clip_planes = {};
  bool zero_to_one = false;  // glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE)
  // A fragment shader that draws red, and depth as green. Empty: the standard one.
  std::string fragment = {};
};

struct Pixel {
  bool drawn = false;
  float depth = 0;  // window depth: 0 near, 1 far
};

// The pixels that were drawn, with their depth.
struct DrawnImage {
  int size = 0;
  std::vector<Pixel> pixels;  // the bottom row first
  const Pixel& At(int x, int y) const { return pixels[y * size + x]; }
};

// Draws the inputs' vertices as triangles, on the current context.
DrawnImage Draw(const std::string& vertex, const Inputs& inputs, const ImageOptions& options);

// The image for people to look at: drawn pixels darken with depth.
harness::Image ColorsOf(const DrawnImage& image);

// The whole target as a mesh of triangles in Direct3D clip space: x and y from -1 to 1 after the
// division by w, depth rising from 1/4 on the left to 3/4 on the right, w from 1 at the bottom to 2
// at the top. Four floats for each vertex.
std::vector<std::array<float, 4>> FullTarget();
constexpr float DepthAt(float x) { return 0.5f + 0.25f * x; }

// The pixels that an image of FullTarget must have.
struct Expectation {
  // A pixel is drawn where dot((x, y, DepthAt(x), 1), plane) >= 0 for each plane.
  std::vector<std::array<double, 4>> planes;
  bool flipped = false;  // upside down
};
struct Difference {
  // Numbers of pixels. A pixel nearer than 1/20 pixel to a plane's edge counts as right.
  int drawn = 0, missing = 0, extra = 0;
  double depth_error = 0;  // the largest error of the pixels that are rightly drawn
};
Difference Compare(const DrawnImage& image, const Expectation& expectation);

}  // namespace clipc::draw
