// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/repeats.h"

#include <cmath>

#include <gtest/gtest.h>

#include "study/numbers.h"

namespace clipc::study {
namespace {

TEST(Repeats, FewAreAllThereIs) {
  EXPECT_EQ(MedianOf({}).median, 0);
  const Repeated of_five = MedianOf({5, 1, 4, 2, 3});
  EXPECT_EQ(of_five.median, 3);
  EXPECT_EQ(of_five.low, 1);
  EXPECT_EQ(of_five.high, 5);
}

// A frame's cost and whatever else the machine does: always more, at times much more.
std::vector<double> Times(Random& random, int count, double load) {
  std::vector<double> times;
  for (int i = 0; i < count; ++i) {
    times.push_back(1 + load * std::pow(random.Unit(), 4));
  }
  return times;
}

TEST(Repeats, TheMedianIsInItsInterval19TimesOf20) {
  Random random(3);
  const double median = 1 + std::pow(0.5, 4);
  int inside = 0;
  double width = 0;
  constexpr int kTimes = 4000;
  for (int i = 0; i < kTimes; ++i) {
    const Repeated repeated = MedianOf(Times(random, 25, 1));
    inside += repeated.low <= median && median <= repeated.high;
    width += (repeated.high - repeated.low) / kTimes;
  }
  EXPECT_GT(inside, 0.945 * kTimes);
  EXPECT_LT(inside, 0.97 * kTimes);  // mutation: one repeat more on each side
  // A tenth of the repeats on each side says what the machine does, and more repeats do not narrow
  // that; the interval of the median they do.
  EXPECT_LT(width, 0.5 * (std::pow(0.9, 4) - std::pow(0.1, 4)));
  double of_more = 0;
  for (int i = 0; i < 200; ++i) {
    const Repeated repeated = MedianOf(Times(random, 400, 1));
    of_more += (repeated.high - repeated.low) / 200;
  }
  EXPECT_LT(of_more, width / 3);
}

}  // namespace
}  // namespace clipc::study
