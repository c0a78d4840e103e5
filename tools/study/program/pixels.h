// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "tools/draw/gl.h"
#include "tools/study/program/studio.h"

namespace clipc::study {

// What a way draws wrongly: fragments counted at each pixel, against polygons that were clipped
// exactly.
struct PixelErrors {
  std::string way;
  bool applies = false;
  long reference = 0;        // fragments of the reference
  long extra = 0, lost = 0;  // fragments too many and too few, summed over the pixels
};

// Draws a knot at the config's depth with each way, and with the reference: each triangle cut at
// the exact distances of its vertices (Wide), its clip-space corners rounded to float once.
class PixelMeter {
 public:
  PixelMeter(draw::Device& device, int width, int height, int detail);
  std::vector<PixelErrors> Measure(const Config& config);
  // Colours, from the bottom row up, of the config drawn with one way.
  std::vector<std::uint8_t> Picture(draw::Device& device, const Config& config, WayKind kind,
                                    int width, int height);

 private:
  Mesh MeshFor(const Setup& setup) const;

  Studio studio_;
  int detail_;
  std::vector<std::unique_ptr<DrawCall>> calls_;  // as AllWays
};

}  // namespace clipc::study
