// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/linear_solve.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include <gtest/gtest.h>

#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

constexpr DoubleDouble kOnes[4] = {{1, 0}, {1, 0}, {1, 0}, {1, 0}};

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
    const DoubleDouble right[4] = {{b[0], 0}, {b[1], 0}, {b[2], 0}, {b[3], 0}};
    const Solution solution = SolveLinear(a, right, {0, 0, 0, 0});
    ASSERT_FALSE(solution.singular);
    for (int k = 0; k < 4; ++k) {
      EXPECT_LE(std::fabs((solution.x[k].high - x[k]) + solution.x[k].low),
                8 * solution.error[k] * 0x1p-53);
      EXPECT_LT(solution.error[k], 1) << "refined beyond double";
    }
  }
}

// Equations and unknowns of any size, and small pivots.
TEST(SolveLinear, SizesDoNotMatter) {
  const auto error = [](double(&&a)[4][4]) {
    double b[4] = {};
    constexpr double kExact[4] = {3, -5, 1, 0};
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) b[i] += a[i][j] * kExact[j];
    }
    const Solution solution =
        SolveLinear(a, {{b[0], 0}, {b[1], 0}, {b[2], 0}, {b[3], 0}}, {0, 0, 0, 0});
    double most = solution.singular ? INFINITY : 0;
    for (int j = 0; j < 4; ++j) {
      EXPECT_LT(solution.error[j], 1) << j;
      most = std::max(most, std::fabs(solution.x[j].high - kExact[j]));
    }
    return most;
  };
  constexpr double kLarge = 0x1p1000, kSmall = 0x1p-600, kTiny = 0x1p-72;
  EXPECT_EQ(error({{kSmall, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}), 0);
  EXPECT_EQ(error({{kSmall, kSmall, 0, 0}, {1, -1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}), 0);
  EXPECT_EQ(error({{kLarge, kLarge, 0, 0},
                   {1.375 * kTiny, 2.75 * kTiny, 0, 0},
                   {0, 0, 1, 0},
                   {0, 0, 0, 1}}),
            0);
  EXPECT_EQ(error({{0x1p-60, 1, 0, 0}, {1, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}), 0);
}

// A right side at the end of double's range keeps its digits; a solution beyond it is not 0.
TEST(SolveLinear, TheEndsOfDoublesRange) {
  Matrix small;
  small.m[0][0] = 0x1.8p-61;
  const Solution solution =
      SolveLinear(small.m, {{0x1p-1060, 0}, {0, 0}, {0, 0}, {0, 0}}, {0, 0, 0, 0});
  EXPECT_EQ(std::scalbn(solution.x[0].high, 1000), 4 / 3.0);
  small.m[0][0] = 0x1p1000;
  EXPECT_EQ(SolveLinear(small.m, {{0x1p-100, 0}, {0, 0}, {0, 0}, {0, 0}}, {0, 0, 0, 0}).x[0].high,
            DBL_MIN);
}

TEST(SolveLinear, ErrorsOfTheRightSideReachTheSolution) {
  const double a[4][4] = {{2, 0, 0, 0}, {0, 4, 0, 0}, {0, 0, 1, 0}, {0, 0, 1, 1}};
  const Solution solution = SolveLinear(a, {}, {1, 1, 1, 0});
  EXPECT_EQ(solution.error[0], 0.5);
  EXPECT_EQ(solution.error[1], 0.25);
  EXPECT_EQ(solution.error[2], 1);
  EXPECT_EQ(solution.error[3], 1);
}

// A translation cancels what another one added, whatever its length.
TEST(SolveLinear, NoTranslationIsTooLong) {
  Random random(2);
  for (const double offset : {0.0, 1e7, 1e13, 1e20, 1e28}) {
    const Matrix there = random.Rigid(offset);
    const DoubleDouble plane[4] = {{0.6, 0}, {0, 0}, {0.8, 0}, {-5, 0x1p-60}};
    DoubleDouble before[4];
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) before[i] = Add(before[i], Multiply(there.m[i][j], plane[j]));
    }
    const Solution solution = SolveLinear(there.m, before, {0, 0, 0, 0});
    for (int i = 0; i < 4; ++i) {
      // The error that twice double's digits leave of the offset.
      const double left = 0x1p-100 * (1 + offset);
      EXPECT_NEAR(solution.x[i].high, plane[i].high, left + 1e-30) << offset;
      EXPECT_LE(std::fabs(solution.x[i].high - plane[i].high), solution.error[i] * 0x1p-53 + 1e-30)
          << offset;
    }
  }
}

// Elimination leaves about ten bits of x here, and each step adds as many.
TEST(SolveLinear, TakesTheStepsThatTheSystemNeeds) {
  constexpr double kLarge = 1999993;
  const double a[4][4] = {
      {kLarge + 1, kLarge, 0, 0}, {kLarge, kLarge - 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  const Solution solution =
      SolveLinear(a, {{3 - 2 * kLarge, 0}, {5 - 2 * kLarge, 0}, {0, 0}, {0, 0}}, {0, 0, 0, 0});
  EXPECT_EQ(solution.x[0].high, 3);
  EXPECT_EQ(solution.x[1].high, -5);
  EXPECT_LT(solution.error[0], 1);
}

// Elimination that has lost nearly everything is not refined into a false answer.
TEST(SolveLinear, WhatIsAlmostSingularIsNotTrusted) {
  const double nearly[4][4] = {{1, 1, 0, 0}, {1, 1 + 0x1p-51, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  const Solution solution = SolveLinear(nearly, kOnes, {0, 0, 0, 0});
  ASSERT_FALSE(solution.singular);
  EXPECT_GT(solution.error[0], 0x1p40);
  // |A^-1| |L| |U| |x| is 4 / away of x here: 46 bits are the limit.
  const auto error = [](double away) {
    const double a[4][4] = {{1, 1, 0, 0}, {1, 1 + away, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    const Solution made = SolveLinear(a, {{0, 0}, {1, 0}, {0, 0}, {0, 0}}, {0, 0, 0, 0});
    return made.error[0] / made.x[0].high;
  };
  EXPECT_GT(std::fabs(error(0x1.8p-45)), 0x1p40);
  EXPECT_LT(std::fabs(error(0x1.1p-44)), 1);
}

TEST(SolveLinear, Singular) {
  EXPECT_TRUE(
      SolveLinear({{0, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}, kOnes, {0, 0, 0, 0})
          .singular);
  EXPECT_TRUE(
      SolveLinear({{1, 2, 0, 0}, {2, 4, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}, kOnes, {0, 0, 0, 0})
          .singular);
}

}  // namespace
}  // namespace clipc::runtime
