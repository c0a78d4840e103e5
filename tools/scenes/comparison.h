// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

namespace clipc::scenes {

// Numbers of pixels that differ in color, alpha aside.
struct Comparison {
  int cut_pixels = 0;        // pixels within one pixel of a cut
  int differ_at_cut = 0;     // pixels of these that differ
  int differ_elsewhere = 0;  // other pixels that differ
};

// Compares two images of the same size, RGBA with a byte each. `cuts` is a third such image,
// which is not black where a cut is near.
Comparison Compare(const std::vector<std::uint8_t>& one, const std::vector<std::uint8_t>& other,
                   const std::vector<std::uint8_t>& cuts);

// Whether two ways of clipping agree: no pixel differs away from the cuts, and at the cuts no more
// pixels differ than the two errors explain. Cuts are about cut_pixels / 2 long, since a pixel to
// both sides counts. Along each pixel of that length the cuts of the two images lie up to 2 *
// (cut_error + 1/256) apart; 1/256 is the grid that rasterisers snap corners to. That is the
// probability that the pixel's center lies between the cuts. The factor 2 and the 4 allow for
// chance.
bool Agree(const Comparison& comparison, double cut_error);

}  // namespace clipc::scenes
