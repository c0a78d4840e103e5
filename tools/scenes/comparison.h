// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

namespace clipc::scenes {

// How many pixels differ in color, alpha aside.
struct Comparison {
  int cut_pixels = 0;     // that lie within one pixel of a cut
  int differ_at_cut = 0;  // of those
  int differ_elsewhere = 0;
};

// Three pictures of the same size, RGBA, a byte each; `cuts` is not black where a cut is near.
Comparison Compare(const std::vector<std::uint8_t>& one, const std::vector<std::uint8_t>& other,
                   const std::vector<std::uint8_t>& cuts);

// The two ways of clipping agree: no pixel differs away from the cuts, and at the cuts not more
// than the two errors explain. Cuts are about cut_pixels / 2 long, since a pixel to both sides
// counts; along each of those pixels the cuts of the two pictures lie up to 2 * (cut_error + 1/256)
// apart, 1/256 being the grid that rasterisers snap corners to. A center falls between with that
// probability; the factor 2 and the 4 allow for chance.
bool Agree(const Comparison& comparison, double cut_error);

}  // namespace clipc::scenes
