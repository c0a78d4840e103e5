// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/scenes/comparison.h"

#include <cstddef>

namespace clipc::scenes {

Comparison Compare(const std::vector<std::uint8_t>& one, const std::vector<std::uint8_t>& other,
                   const std::vector<std::uint8_t>& cuts) {
  Comparison result;
  for (std::size_t i = 0; i + 3 < cuts.size(); i += 4) {
    const bool at_cut = cuts[i] != 0;
    result.cut_pixels += at_cut;
    const bool same = one.size() == cuts.size() && other.size() == cuts.size() &&
                      one[i] == other[i] && one[i + 1] == other[i + 1] &&
                      one[i + 2] == other[i + 2];
    if (!same) ++(at_cut ? result.differ_at_cut : result.differ_elsewhere);
  }
  return result;
}

bool Agree(const Comparison& comparison, double cut_error) {
  const double length = comparison.cut_pixels / 2.0, apart = 2 * (cut_error + 1.0 / 256);
  return comparison.differ_elsewhere == 0 && comparison.differ_at_cut <= 2 * length * apart + 4;
}

}  // namespace clipc::scenes
