// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/method.h"

namespace clipc::study {

// The method `xyw1`, as it is and with one rounding after the other left out, which no shader can
// do.
std::vector<Method> Xyw1Roundings();

// The errors of one of these methods on many draws.
struct RoundingCost {
  std::string rounding;
  int draws = 0;
  double mean = 0, worst = 0;  // pixels; of the draws' 99th percentiles
  int over = 0;                // draws whose 99th percentile is over kXyw1Claim
};

// The number of pixels that a 99th percentile should stay under.
inline constexpr double kXyw1Claim = 0.002;

// Random perspectives of `fov` degrees from bottom to top, and random planes, cutting surfaces that
// meet them at 5 degrees or more. `edges` of each draw are measured. Equal arguments give equal
// results.
std::vector<RoundingCost> MeasureRoundings(double fov, int draws, long edges, std::uint64_t seed);

}  // namespace clipc::study
