// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

namespace clipc::study {

// The median of repeats of a measurement, and between which of them the median of all repeats that
// there could be lies, 19 times of 20. It follows from the order of the repeats alone: what else
// the machine does spreads single repeats, and more of them narrow this. Of five and less it is all
// of them.
struct Repeated {
  double median = 0, low = 0, high = 0;
};
Repeated MedianOf(std::vector<double> repeats);

}  // namespace clipc::study
