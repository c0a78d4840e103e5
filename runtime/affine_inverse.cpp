// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/affine_inverse.h"

#include <cmath>

// The mark of functions that are inlined into a function for processors with a fused multiply-add
// and into one for the build's own target: the same operations, so the same results.
#if defined(__GNUC__) && defined(__x86_64__) && !defined(__FMA__) && !defined(__MINGW32__)
#define CLIPC_HAS_FMA_CLONE 1
#else
#define CLIPC_HAS_FMA_CLONE 0
#endif

namespace clipc::runtime {
namespace {

// What is lost of a determinant at most, and the range of a matrix's and of a plane's elements.
constexpr double kMostCancelled = 0x1p20;
constexpr double kLeastOfMatrix = 0x1p-100, kLargestOfMatrix = 0x1p100;
constexpr double kLeastOfPlane = 0x1p-200, kLargestOfPlane = 0x1p200;
// The largest rounding error of a sum of four products of DoubleDoubles, in units of 2^-53.
constexpr double kRounding = 0x1p-48;

CLIPC_INLINE bool IsWithin(double number, double least, double largest) {
  const double size = std::fabs(number);
  return (size <= largest) & ((size >= least) | (size == 0));
}

// a * b - c * d, rounded once.
CLIPC_INLINE DoubleDouble Difference(double a, double b, double c, double d) {
  return Add(ExactProduct(a, b), ExactProduct(-c, d));
}

// The sum of three numbers, right to about 2^-104 of the largest of them.
CLIPC_INLINE DoubleDouble Sum(DoubleDouble a, DoubleDouble b, DoubleDouble c) {
  const DoubleDouble first = ExactSum(a.high, b.high), all = ExactSum(first.high, c.high);
  return ExactSum(all.high, all.low + (first.low + (a.low + b.low + c.low)));
}

CLIPC_INLINE DoubleDouble Reciprocal(DoubleDouble number) {
  const double first = 1 / number.high;
  const DoubleDouble rest = Add({1, 0}, Multiply(-first, number));
  return ExactSumOfOrdered(first, rest.high / number.high);
}

CLIPC_INLINE void Invert(const Matrix& matrix, AffineInverse& inverse) {
  const auto& m = matrix.m;
  bool in_range = m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
  for (const auto& row : m) {
    for (int i = 0; i < 3; ++i) in_range &= IsWithin(row[i], kLeastOfMatrix, kLargestOfMatrix);
  }
  if (!in_range) return;
  for (int i = 0; i < 3; ++i) {
    const auto &a = m[(i + 1) % 3], &b = m[(i + 2) % 3];
    for (int j = 0; j < 3; ++j) {
      const int k = (j + 1) % 3, l = (j + 2) % 3;
      inverse.cofactor[i][j] = Difference(a[k], b[l], a[l], b[k]);
    }
    inverse.translation[i] = m[3][i];
  }
  DoubleDouble products[3];
  double size = 0;
  for (int i = 0; i < 3; ++i) {
    products[i] = Multiply(m[0][i], inverse.cofactor[0][i]);
    size += std::fabs(products[i].high);
  }
  const DoubleDouble determinant = Sum(products[0], products[1], products[2]);
  const double lost = size / std::fabs(determinant.high);
  if (!(lost <= kMostCancelled)) return;  // nor if both are 0
  inverse.reciprocal = Reciprocal(determinant);
  inverse.lost = kRounding * lost;
  inverse.holds = true;
}

CLIPC_INLINE bool Take(const AffineInverse& inverse, const Bounded& before, Bounded& after) {
  bool in_range = true;
  for (const DoubleDouble& number : before.plane)
    in_range &= IsWithin(number.high, kLeastOfPlane, kLargestOfPlane);
  if (!in_range) return false;
  DoubleDouble moved[3];
  double w_error = before.error[3], w_size = std::fabs(before.plane[3].high);
  for (int i = 0; i < 3; ++i) {
    DoubleDouble products[3];
    double size = 0, reach = 0;
    for (int j = 0; j < 3; ++j) {
      products[j] = Multiply(inverse.cofactor[j][i], before.plane[j]);
      size += std::fabs(products[j].high);
      reach += std::fabs(inverse.cofactor[j][i].high) * before.error[j];
    }
    const DoubleDouble x = Multiply(Sum(products[0], products[1], products[2]), inverse.reciprocal);
    const double error = (kRounding * size + reach) * std::fabs(inverse.reciprocal.high) +
                         inverse.lost * std::fabs(x.high);
    after.plane[i] = x;
    after.error[i] = error;
    moved[i] = Multiply(-inverse.translation[i], x);
    w_error += std::fabs(inverse.translation[i]) * error;
    w_size += std::fabs(moved[i].high);
  }
  after.plane[3] = Add(before.plane[3], Sum(moved[0], moved[1], moved[2]));
  after.error[3] = w_error + kRounding * w_size;
  return true;
}

#if CLIPC_HAS_FMA_CLONE
__attribute__((target("fma"))) void InvertByFma(const Matrix& matrix, AffineInverse& inverse) {
  Invert(matrix, inverse);
}
__attribute__((target("fma"))) bool TakeByFma(const AffineInverse& inverse, const Bounded& before,
                                              Bounded& after) {
  return Take(inverse, before, after);
}
bool HasFma() { return __builtin_cpu_supports("fma") != 0; }
#endif

}  // namespace

AffineInverse InverseOfAffine(const Matrix& matrix) noexcept {
  AffineInverse inverse;
#if CLIPC_HAS_FMA_CLONE
  if (HasFma()) {
    InvertByFma(matrix, inverse);
    return inverse;
  }
#endif
  Invert(matrix, inverse);
  return inverse;
}

bool TakeThrough(const AffineInverse& inverse, const Bounded& before, Bounded& after) noexcept {
#if CLIPC_HAS_FMA_CLONE
  if (HasFma()) return TakeByFma(inverse, before, after);
#endif
  return Take(inverse, before, after);
}

}  // namespace clipc::runtime
