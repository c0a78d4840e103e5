// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "study/program/studio.h"

namespace clipc::study {

// The fragments that a way draws wrongly: those at each pixel are compared with those of polygons
// that were clipped exactly.
struct PixelErrors {
  std::string way;
  bool applies = false;
  long reference = 0;        // fragments of the reference
  long extra = 0, lost = 0;  // fragments too many and too few, summed over the pixels
};

// Draws a knot at the config's depth with each way, and the reference: each triangle is cut at the
// exact distances of its vertices (Wide), and its clip-space corners are rounded to float once. An
// OpenGL context of the compatibility profile must be current.
class PixelMeter {
 public:
  PixelMeter(int width, int height, int detail);
  std::vector<PixelErrors> Measure(const Config& config);

 private:
  Studio studio_;
  int detail_;
  std::vector<std::unique_ptr<DrawCall>> calls_;  // beside kWays
};

// The knot of that detail drawn once with one way, over white; none where the way cannot be used.
std::optional<harness::Image> DrawOnce(const Config& config, WayKind kind, int detail, int width,
                                       int height);

}  // namespace clipc::study
