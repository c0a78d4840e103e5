// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/linear_solve.h"

#include <cmath>

#include <gtest/gtest.h>

#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

TEST(SolveLinear, SolvesAndBoundsItsError) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    double a[4][4], x[4], b[4] = {};
    // Small integers: b is exact, so x is.
    for (int row = 0; row < 4; ++row) {
      x[row] = static_cast<double>(random.Below(200)) - 100;
      for (double& element : a[row]) element = static_cast<double>(random.Below(2000)) - 1000;
    }
    for (int row = 0; row < 4; ++row) {
      const double scale =
          std::exp2(static_cast<double>(random.Below(80)) - 40);  // rows of very different sizes
      for (int k = 0; k < 4; ++k) b[row] += a[row][k] * x[k];
      for (double& element : a[row]) element *= scale;
      b[row] *= scale;
    }
    const Solution solution = SolveLinear(a, b, {0, 0, 0, 0});
    ASSERT_FALSE(solution.singular);
    for (int k = 0; k < 4; ++k)
      EXPECT_LE(std::fabs(solution.x[k] - x[k]), 8 * solution.error[k] * 0x1p-53);
  }
}

TEST(SolveLinear, ErrorsOfTheRightSideReachTheSolution) {
  const double a[4][4] = {{2, 0, 0, 0}, {0, 4, 0, 0}, {0, 0, 1, 0}, {0, 0, 1, 1}};
  const Solution solution = SolveLinear(a, {0, 0, 0, 0}, {1, 1, 1, 0});
  EXPECT_EQ(solution.error[0], 0.5);
  EXPECT_EQ(solution.error[1], 0.25);
  EXPECT_EQ(solution.error[2], 1);
  EXPECT_EQ(solution.error[3], 1);
}

TEST(SolveLinear, Singular) {
  EXPECT_TRUE(SolveLinear({{0, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}, {1, 1, 1, 1},
                          {0, 0, 0, 0})
                  .singular);
  EXPECT_TRUE(SolveLinear({{1, 2, 0, 0}, {2, 4, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}, {1, 1, 1, 1},
                          {0, 0, 0, 0})
                  .singular);
}

}  // namespace
}  // namespace clipc::runtime
