// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/advice.h"

namespace clipc::study {

// The cost of a way: CPU time of the process, whose threads draw for llvmpipe, relative to drawing
// without planes.
struct Cost {
  // "image": 1280x720; "vertices": 64x64, hardly a fragment; "cut": the image, most of it
  // clipped.
  std::string workload;
  std::string way;
  int planes = 0;
  double median_ms = 0, least_ms = 0;
  double ratio = 1;  // of the medians
  // The median of the ratios to the frames without planes just before and after, which other work
  // of the machine slows down as much.
  double paired_ratio = 1;
  // The bounds that the median of such ratios lies between, 19 times of 20 (study/repeats.h).
  double paired_low = 1, paired_high = 1;
};

// Measures all ways. Each round draws each way once, in an order of its own, so that no way always
// follows the same one. Calls `progress` with the share of the work that is done, 0 to 1. An OpenGL
// context of the compatibility profile must be current.
std::vector<Cost> MeasureSpeed(int rounds, int detail, const std::function<void(double)>& progress);

// The paired ratios of the rows "image".
CostTable TableOf(const std::vector<Cost>& costs);
// The paired ratios in a speed.csv that clipc-study wrote. Throws DrawError for another file.
CostTable ReadCosts(const std::string& path);

}  // namespace clipc::study
