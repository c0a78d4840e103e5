// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/repeats.h"

#include <algorithm>
#include <cmath>

namespace clipc::study {
namespace {

constexpr double kOutside = 0.05;

// The number of the least repeats, and of the largest, that may be left out of the interval. Each
// repeat is below the median as a coin falls: if `below` repeats are, an interval that begins at
// the next one misses the median.
std::size_t LeftOut(std::size_t count) {
  const auto repeats = static_cast<double>(count);
  double share = std::exp2(-repeats);  // of all cases: those with `below` repeats below the median
  double misses = 0;
  std::size_t below = 0;
  for (; 2 * (misses + share) <= kOutside; ++below) {
    misses += share;
    share *= (repeats - static_cast<double>(below)) / (static_cast<double>(below) + 1);
  }
  return below == 0 ? 0 : below - 1;
}

}  // namespace

Repeated MedianOf(std::vector<double> repeats) {
  if (repeats.empty()) return {};
  std::ranges::sort(repeats);
  const std::size_t out = LeftOut(repeats.size());
  return {repeats[repeats.size() / 2], repeats[out], repeats[repeats.size() - 1 - out]};
}

}  // namespace clipc::study
