// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cmath>

// Numbers of twice double's digits. Not part of the public interface.
namespace clipc::runtime {

// The number high + low; low is at most half a unit in the last place of high.
struct DoubleDouble {
  double high = 0, low = 0;
};

// a + b, exactly: Knuth's two-sum.
inline DoubleDouble ExactSum(double a, double b) {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

// a + b, exactly where |a| >= |b|: Dekker's.
inline DoubleDouble ExactSumOfOrdered(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// a + b with a relative error of about 2^-104.
inline DoubleDouble Add(DoubleDouble a, DoubleDouble b) {
  DoubleDouble sum = ExactSum(a.high, b.high);
  const DoubleDouble rest = ExactSum(a.low, b.low);
  sum = ExactSumOfOrdered(sum.high, sum.low + rest.high);
  return ExactSumOfOrdered(sum.high, sum.low + rest.low);
}

// a * b with a relative error of about 2^-104.
inline DoubleDouble Multiply(double a, DoubleDouble b) {
  const double product = a * b.high;
  return ExactSumOfOrdered(product, std::fma(a, b.high, -product) + a * b.low);
}

}  // namespace clipc::runtime
