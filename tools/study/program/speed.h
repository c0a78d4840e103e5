// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/draw/gl.h"

namespace clipc::study {

// What a way costs: CPU time of the process (all threads; llvmpipe draws with it), relative to
// drawing without planes.
struct Cost {
  std::string setting;  // "picture": 1280x720; "vertices": 64x64, hardly a fragment; "cut": the
                        // picture, most of it clipped
  std::string way;
  int planes = 0;
  double median_ms = 0, least_ms = 0;
  double ratio = 1;  // of the medians
  // The median of the ratios to the frames without planes just before and after: what else the
  // machine does hits them alike.
  double paired_ratio = 1;
};

// Each round draws each way once, in an order of its own, so that no way always follows the same
// one. `progress` is told how much of the whole is done, 0 to 1.
std::vector<Cost> MeasureSpeed(draw::Device& device, int rounds, int detail,
                               const std::function<void(double)>& progress);

}  // namespace clipc::study
