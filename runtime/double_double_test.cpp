// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/double_double.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

#ifdef __SIZEOF_FLOAT128__
// 128 bits hold the product of two doubles.
TEST(DoubleDouble, ProductErrorIsExact) {
  Random random(31);
  for (int i = 0; i < 100000; ++i) {
    const double a = random.Between(-1, 1) * random.Magnitude(1e-40, 1e40);
    const double b = random.Between(-1, 1) * random.Magnitude(1e-40, 1e40);
    const double product = a * b;
    const double error = static_cast<double>(static_cast<Wide>(a) * b - product);
    ASSERT_EQ(ProductError(a, b, product), error) << a << " * " << b;
  }
}

TEST(DoubleDouble, ProductErrorOfLargeFactors) {
  const double large = std::numeric_limits<double>::max(), small = 0x1.234567890abcdp-60;
  const double error = static_cast<double>(static_cast<Wide>(large) * small - large * small);
  EXPECT_EQ(ProductError(large, small, large * small), error);
  EXPECT_EQ(ProductError(small, -large, -large * small), -error);
}
#endif

TEST(DoubleDouble, ProductErrorWhereAProductIsNoNumber) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(std::isfinite(ProductError(infinity, 2, infinity)));
  EXPECT_FALSE(std::isfinite(ProductError(0x1p1000, 0x1p1000, infinity)));
  EXPECT_FALSE(std::isfinite(ProductError(2, infinity, infinity)));
}

}  // namespace
}  // namespace clipc::runtime
