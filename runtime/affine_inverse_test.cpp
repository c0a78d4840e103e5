// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/affine_inverse.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "runtime/linear_solve.h"
#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

Matrix Stretched(Matrix matrix, double x, double y, double z) {
  const double by[4] = {x, y, z, 1};
  for (int i = 0; i < 3; ++i) {
    for (double& element : matrix.m[i]) element *= by[i];
  }
  return matrix;
}

Bounded Unrounded(const Plane& plane) {
  return {{{plane.x, 0}, {plane.y, 0}, {plane.z, 0}, {plane.w, 0}}, {}};
}

// Whatever the sizes of the axes and the length of the way, the answer is the elimination's.
TEST(AffineInverse, IsWhatEliminationFinds) {
  Random random(41);
  int held = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto size = [&] { return random.Magnitude(1e-5, 1e5); };
    Matrix matrix = random.Rigid(random.Magnitude(1e-3, 1e9));
    matrix = Stretched(matrix, size(), size(), size());
    const Plane plane = random.PlaneAt(random.Between(-1, 1) * random.Magnitude(1e-3, 1e9));
    const Bounded before = Unrounded(plane);
    const AffineInverse inverse = InverseOfAffine(matrix);
    ASSERT_TRUE(inverse.holds);
    Bounded after;
    ASSERT_TRUE(TakeThrough(inverse, before, after));
    const Solution solution = SolveLinear(matrix.m, before.plane, before.error);
    for (int k = 0; k < 4; ++k) {
      const double difference =
          (after.plane[k].high - solution.x[k].high) + (after.plane[k].low - solution.x[k].low);
      EXPECT_LE(std::fabs(difference), (after.error[k] + solution.error[k]) * 0x1p-53);
      EXPECT_LE(after.error[k], 0x1p-20 * std::fabs(after.plane[k].high)) << "twice the digits";
      held += after.plane[k].high == solution.x[k].high ? 1 : 0;
    }
  }
  EXPECT_GE(held, 79'990);
}

// The error of the plane before and the matrix's own cancellation are in the bound.
TEST(AffineInverse, BoundsItsError) {
  Random random(42);
  int held = 0;
  for (int i = 0; i < 20'000; ++i) {
    Matrix matrix = random.NearlySingular(2, random.Magnitude(1e-9, 1e-2));
    for (int j = 0; j < 4; ++j) matrix.m[j][3] = j == 3 ? 1 : 0;
    const AffineInverse inverse = InverseOfAffine(matrix);
    if (!inverse.holds) continue;
    ++held;
    const Plane plane = random.PlaneAt(random.Between(-9, 9));
    Bounded before = Unrounded(plane), after;
    Wide c[4], r[3][3];
    for (int j = 0; j < 4; ++j) {
      before.error[j] = random.Magnitude(1e-9, 1);
      c[j] = before.plane[j].high + static_cast<Wide>(before.error[j]) * 0x1p-53;
    }
    ASSERT_TRUE(TakeThrough(inverse, before, after));
    Wide determinant = 0;
    for (int j = 0; j < 3; ++j) {
      const auto &a = matrix.m[(j + 1) % 3], &b = matrix.m[(j + 2) % 3];
      for (int k = 0; k < 3; ++k)
        r[j][k] = static_cast<Wide>(a[(k + 1) % 3]) * b[(k + 2) % 3] -
                  static_cast<Wide>(a[(k + 2) % 3]) * b[(k + 1) % 3];
    }
    for (int k = 0; k < 3; ++k) determinant += matrix.m[0][k] * r[0][k];
    Wide exact[4] = {0, 0, 0, c[3]};
    for (int k = 0; k < 3; ++k) {
      for (int j = 0; j < 3; ++j) exact[k] += r[j][k] * c[j] / determinant;
      exact[3] -= matrix.m[3][k] * exact[k];
    }
    for (int k = 0; k < 4; ++k) {
      const Wide off = static_cast<Wide>(after.plane[k].high) + after.plane[k].low - exact[k];
      EXPECT_LE(std::fabs(static_cast<double>(off)), after.error[k] * 0x1p-53 * (1 + 0x1p-20));
    }
  }
  EXPECT_GT(held, 5'000);
}

// What is exactly 0 stays so: axes that are the world's leave no dust of roundings.
TEST(AffineInverse, KeepsZeros) {
  Matrix matrix;
  matrix.m[3][0] = 0.1, matrix.m[3][1] = 1e9, matrix.m[3][2] = -7.3;
  Bounded after;
  ASSERT_TRUE(TakeThrough(InverseOfAffine(matrix), Unrounded({0, 3, 0, 0.5}), after));
  EXPECT_EQ(after.plane[0].high, 0);
  EXPECT_EQ(after.plane[1].high, 3);
  EXPECT_EQ(after.plane[2].high, 0);
  EXPECT_EQ(after.plane[3].high, 0.5 - 3e9);
  EXPECT_EQ(after.error[0], 0);
}

TEST(AffineInverse, IsNotForEveryMatrix) {
  const auto with = [](int i, int j, double element) {
    Matrix matrix;
    matrix.m[i][j] = element;
    return InverseOfAffine(matrix).holds;
  };
  EXPECT_TRUE(with(3, 0, 1e20));
  EXPECT_TRUE(with(1, 1, -1e-20));
  EXPECT_FALSE(with(1, 1, 0)) << "singular";
  EXPECT_FALSE(with(0, 3, 1e-9)) << "not affine";
  EXPECT_FALSE(with(3, 3, 2)) << "not affine";
  for (const double element :
       {std::numeric_limits<double>::quiet_NaN(), 1e300, 1e-300, 1e40, 1e-40}) {
    EXPECT_FALSE(with(0, 0, element)) << element;
    EXPECT_FALSE(with(3, 1, element)) << element;
  }
  Random random(43);
  EXPECT_FALSE(InverseOfAffine(random.NearlySingular(2, 1e-12)).holds);
  Bounded after;
  for (const double element : {1e300, 1e-300})
    EXPECT_FALSE(TakeThrough(InverseOfAffine(Matrix()), Unrounded({0, 1, 0, element}), after));
}

}  // namespace
}  // namespace clipc::runtime
