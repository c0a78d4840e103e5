// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cmath>

#include <gtest/gtest.h>

#include "study/numbers.h"

namespace clipc::study {
namespace {

TEST(Float32, SumsFromTheLeftAndFusesNothing) {
  // 1 + 2^-24 rounds to 1 each time; from the right the two halves would add up first.
  const Vec4<float> a = {{1, 0x1p-24f, 0x1p-24f, 0}}, ones = {{1, 1, 1, 1}};
  EXPECT_EQ(Dot(a, ones), 1.0f);
  // (1 + e)^2 - (1 + 2 e) is 0 when the product rounds, e^2 when it is fused.
  const Vec4<float> b = {{-(1 + 0x1p-11f), 1 + 0x1p-12f, 0, 0}}, c = {{1, 1 + 0x1p-12f, 0, 0}};
  EXPECT_EQ(Dot(b, c), 0.0f);
}

TEST(Float32, InverseIsOne) {
  Random random(4);
  Mat4<double> m;
  for (auto& row : m.m) {
    for (double& x : row) x = random.Between(-1, 1);
  }
  const Mat4<double> one = Multiply(m, InverseOf(m));
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(one.m[i][j], i == j, 1e-13);
  }
}

}  // namespace
}  // namespace clipc::study
