// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cmath>

// The mark of functions that are inlined into clones of others for several processors, too. There
// are none for mingw-w64, whose products call themselves.
#if defined(__GNUC__) && !defined(__MINGW32__)
#define CLIPC_INLINE inline __attribute__((always_inline))
#else
#define CLIPC_INLINE inline
#endif

/// Numbers of twice double's digits. Not part of the public interface.
namespace clipc::runtime {

/// The number high + low; low is at most half a unit in the last place of high.
struct DoubleDouble {
  double high = 0, low = 0;
};

/// a + b, exactly: Knuth's two-sum.
CLIPC_INLINE DoubleDouble ExactSum(double a, double b) {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// a + b, exactly where |a| >= |b|: Dekker's.
CLIPC_INLINE DoubleDouble ExactSumOfOrdered(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b with a relative error of about 2^-104.
CLIPC_INLINE DoubleDouble Add(DoubleDouble a, DoubleDouble b) {
  DoubleDouble sum = ExactSum(a.high, b.high);
  const DoubleDouble rest = ExactSum(a.low, b.low);
  sum = ExactSumOfOrdered(sum.high, sum.low + rest.high);
  return ExactSumOfOrdered(sum.high, sum.low + rest.low);
}

/// a * b - product, where product is a * b as rounded: exactly, unless that underflows.
CLIPC_INLINE double ProductError(double a, double b, double product) {
#if defined(__MINGW32__) && !defined(__FMA__)
  // The fma of mingw-w64 rounds more than once. This is Dekker's product: each factor is the sum of
  // two halves, whose products are exact. Halving one beyond kLarge would overflow.
  constexpr double kLarge = 0x1p990, kSmaller = 0x1p-60;
  if (!std::isfinite(product)) return product - product;
  if (std::fabs(a) > kLarge) return ProductError(a * kSmaller, b, product * kSmaller) / kSmaller;
  if (std::fabs(b) > kLarge) return ProductError(a, b * kSmaller, product * kSmaller) / kSmaller;
  const auto high_half = [](double x) {
    const double wide = x * 0x1.0000002p27;
    return wide - (wide - x);
  };
  const double a_high = high_half(a), a_low = a - a_high;
  const double b_high = high_half(b), b_low = b - b_high;
  return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
#else
  return std::fma(a, b, -product);
#endif
}

/// a * b, exactly, unless that underflows.
CLIPC_INLINE DoubleDouble ExactProduct(double a, double b) {
  const double product = a * b;
  return {product, ProductError(a, b, product)};
}

/// a * b with a relative error of about 2^-104.
CLIPC_INLINE DoubleDouble Multiply(double a, DoubleDouble b) {
  const double product = a * b.high;
  return ExactSumOfOrdered(product, ProductError(a, b.high, product) + a * b.low);
}
CLIPC_INLINE DoubleDouble Multiply(DoubleDouble a, DoubleDouble b) {
  const double product = a.high * b.high;
  const double rest = a.high * b.low + a.low * b.high;
  return ExactSumOfOrdered(product, ProductError(a.high, b.high, product) + rest);
}

}  // namespace clipc::runtime
