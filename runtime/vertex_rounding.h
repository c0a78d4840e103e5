// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "matrix.h"

/// The roundings of a vertex on its way through matrices in float, as variances. Not part of the
/// public interface.
namespace clipc::runtime::rounding {

inline constexpr std::uint64_t kExponent = 0x7ff0'0000'0000'0000, kMantissa = 0x000f'ffff'ffff'ffff;
// The largest power of two that is not above |x|, or that of float's least normal number. The
// functions of <cmath> for exponents take most of a prediction's time.
inline double PowerOf(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits &= kExponent;
  std::memcpy(&x, &bits, sizeof bits);
  return std::max(x, 0x1p-126);
}
// The variance of the error that rounding a number of this size to float adds, evenly over half a
// unit in the last place; none for 0.
inline double Rounding(double x) {
  if (x == 0) return 0;
  const double half_unit = PowerOf(x) * 0x1p-24;
  return half_unit * half_unit / 3;
}
// Whether `x` is a power of two, which float holds and multiplies without rounding.
inline bool IsExact(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return x != 0 && std::isfinite(x) && (bits & kMantissa) == 0;
}
// The variance that rounding adds to the sum of two floats; none where one of them is 0.
inline double RoundingOfSum(double a, double b) { return a == 0 || b == 0 ? 0 : Rounding(a + b); }
inline double RoundingOfConstant(double x) { return IsExact(x) ? 0 : Rounding(x); }

/// How the application multiplies the matrices with each other in float; kNone: not at all, the
/// shader multiplies the vertex by one after the other.
enum class FloatProduct {
  kNone,
  kFromLeft,   ///< (matrices[0] matrices[1]) matrices[2]
  kFromRight,  ///< matrices[0] (matrices[1] matrices[2])
};

/// The way of a vertex through matrices: v * matrices[0] * matrices[1] ..., from left to right in
/// float.
struct VertexArithmetic {
  Matrix matrices[3];
  int count = 0;
  FloatProduct product = FloatProduct::kNone;  ///< the vertex is multiplied with it
};

struct Vector4 {
  double c[4];
};

/// The slopes of a number by the vector before each matrix and after the last.
struct Slopes {
  Vector4 at[4] = {};
};

/// A vertex's way through the matrices, which outlive it, and the error that it adds to a number
/// that depends by slopes on what comes out.
class Chain {
 public:
  explicit Chain(const VertexArithmetic& arithmetic);

  Slopes SlopesOf(const Vector4& last) const;
  Vector4 Last(const double (&place)[3]) const;
  /// The variances of the error: of the part that all vertices share, from constants, and of the
  /// part that each vertex has of its own, from the shader's operations.
  double SharedAt(const double (&place)[3], const Slopes& slopes) const;
  double OwnAt(const double (&place)[3], const Slopes& slopes) const;

 private:
  const VertexArithmetic& arithmetic_;
  Matrix in_float_[3];  // each matrix
  Matrix products_[3];  // of the matrices up to each, in float
  Matrix rests_[3];     // of the matrices from each on, in float
};

}  // namespace clipc::runtime::rounding
