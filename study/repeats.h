// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

namespace clipc::study {

// The median of repeats of a measurement, and the interval of repeats in which the median of all
// repeats that there could be lies, 19 times of 20. The interval follows from the order of the
// repeats alone: what else the machine does spreads single repeats, and more repeats narrow the
// interval. For eight repeats and fewer the interval reaches from the least to the largest; for
// five and fewer the median lies outside more often.
struct Repeated {
  double median = 0, low = 0, high = 0;
};
Repeated MedianOf(std::vector<double> repeats);

}  // namespace clipc::study
