// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/evaluate_math.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include "base/invariant.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

namespace clipc::ir {
namespace {

Word Truth(bool value) { return value ? 1 : 0; }

// ---- operators

template <typename T>
Word Comparison(BinaryOp op, T left, T right) {
  using enum BinaryOp;
  switch (op) {
    case kLess: return Truth(left < right);
    case kGreater: return Truth(left > right);
    case kLessEqual: return Truth(left <= right);
    case kGreaterEqual: return Truth(left >= right);
    case kEqual: return Truth(left == right);
    default: return Truth(left != right);
  }
}

// The remainder x - y * trunc(x / y) with one rounding for each operator: a product is stored
// before it is used.
template <typename T>
T TruncatedRemainder(T x, T y) {
  const T quotient = x / y;
  const T product = y * std::trunc(quotient);
  return x - product;
}

template <typename T>
Word FloatBinary(BinaryOp op, T left, T right) {
  using enum BinaryOp;
  if (IsComparison(op)) return Comparison(op, left, right);
  switch (op) {
    case kMul: return BitsOf(left * right);
    case kDiv: return BitsOf(left / right);
    case kMod: return BitsOf(TruncatedRemainder(left, right));
    case kAdd: return BitsOf(left + right);
    default: CLIPC_CHECK(op == kSub); return BitsOf(left - right);
  }
}

template <typename Unsigned>
Unsigned UnsignedDivide(Unsigned left, Unsigned right, bool remainder) {
  if (right == 0) return std::numeric_limits<Unsigned>::max();
  return remainder ? left % right : left / right;
}

// Divides the magnitudes as udiv does, then sets the sign: the quotient is negative when the signs
// differ, and the remainder has the dividend's sign.
template <typename Unsigned>
Unsigned SignedDivide(Unsigned left, Unsigned right, bool remainder) {
  using Signed = std::make_signed_t<Unsigned>;
  const bool left_negative = static_cast<Signed>(left) < 0;
  const bool right_negative = static_cast<Signed>(right) < 0;
  const Unsigned magnitude = UnsignedDivide<Unsigned>(
      left_negative ? 0 - left : left, right_negative ? 0 - right : right, remainder);
  const bool negate = remainder ? left_negative : left_negative != right_negative;
  return negate ? 0 - magnitude : magnitude;
}

// The integers are computed without sign, which is defined where the result does not fit.
template <typename T>
Word IntegerBinary(BinaryOp op, T left_value, T right_value) {
  using enum BinaryOp;
  using Unsigned = std::make_unsigned_t<T>;
  if (IsComparison(op)) return Comparison(op, left_value, right_value);
  const auto left = static_cast<Unsigned>(left_value), right = static_cast<Unsigned>(right_value);
  const Unsigned count = right & (std::numeric_limits<Unsigned>::digits - 1);
  switch (op) {
    case kMul: return Unsigned{left * right};
    case kDiv:
    case kMod:
      return std::is_signed_v<T> ? SignedDivide(left, right, op == kMod)
                                 : UnsignedDivide(left, right, op == kMod);
    case kAdd: return Unsigned{left + right};
    case kSub: return Unsigned{left - right};
    case kShiftLeft: return Unsigned{left << count};
    case kShiftRight: return static_cast<Unsigned>(left_value >> count);
    case kBitAnd: return left & right;
    case kBitXor: return left ^ right;
    default: CLIPC_CHECK(op == kBitOr); return left | right;
  }
}

Word BoolBinary(BinaryOp op, Word left, Word right) {
  if (IsComparison(op)) return Comparison(op, left, right);
  switch (op) {
    case BinaryOp::kBitXor: return left ^ right;
    case BinaryOp::kBitOr:
    case BinaryOp::kLogicalOr:
    case BinaryOp::kShortCircuitOr: return left | right;
    default: return left & right;
  }
}

// ---- component-wise intrinsics

// The result is computed in double; the caller rounds it once, the same on every host.
double Transcendental(Intrinsic op, double x) {
  using enum Intrinsic;
  switch (op) {
    case kAcos: return std::acos(x);
    case kAsin: return std::asin(x);
    case kAtan: return std::atan(x);
    case kCos: return std::cos(x);
    case kCosh: return std::cosh(x);
    case kExp: return std::exp(x);
    case kExp2: return std::exp2(x);
    case kLog: return std::log(x);
    case kLog10: return std::log10(x);
    case kLog2: return std::log2(x);
    case kRsqrt: return 1 / std::sqrt(x);
    case kSin: return std::sin(x);
    case kSinh: return std::sinh(x);
    case kTan: return std::tan(x);
    default: CLIPC_CHECK(op == kTanh); return std::tanh(x);
  }
}

template <typename T>
T FloatUnary(Intrinsic op, T x) {
  using enum Intrinsic;
  switch (op) {
    case kAbs: return std::fabs(x);
    case kCeil: return std::ceil(x);
    case kDegrees: return x * static_cast<T>(57.295779513082320877);
    case kFloor: return std::floor(x);
    case kFrac: return x - std::floor(x);
    case kRadians: return x * static_cast<T>(0.017453292519943295769);
    case kRcp: return 1 / x;
    case kRound: return std::nearbyint(x);  // half to even in the default rounding mode
    case kSaturate: return std::fmin(std::fmax(x, T{0}), T{1});  // fmax drops a NaN
    case kSqrt: return std::sqrt(x);
    case kTrunc: return std::trunc(x);
    default: return static_cast<T>(Transcendental(op, x));
  }
}

template <typename T>
T SmoothstepOf(T low, T high, T x) {
  const T t = FloatUnary(Intrinsic::kSaturate, (x - low) / (high - low));
  const T slope = 3 - 2 * t;
  return t * t * slope;
}

// x to the power of a whole number of at least 1: the product of x, x * x, x * x * x * x and so on,
// from the least on, as fxc multiplies (TranslatePowUsingFxcMulOnlyPattern in DXC's
// HLOperationLower.cpp).
template <typename T>
T WholePowerOf(T x, std::uint32_t power) {
  T product = 1;
  for (bool is_first = true; power != 0; power >>= 1, x = x * x) {
    if (!(power & 1)) continue;
    product = is_first ? x : product * x;
    is_first = false;
  }
  return product;
}

template <typename T>
T FloatFunction(Intrinsic op, T x, T y, T z) {
  using enum Intrinsic;
  switch (op) {
    case kAtan2: return static_cast<T>(std::atan2(static_cast<double>(x), static_cast<double>(y)));
    case kFmod: return TruncatedRemainder(x, y);
    case kLdexp: return x * static_cast<T>(std::exp2(static_cast<double>(y)));
    case kMax: return std::fmax(x, y);  // of a number and NaN, the number
    case kMin: return std::fmin(x, y);
    case kPow: return PowOf(x, y);
    case kWholePower: return WholePowerOf(x, static_cast<std::uint32_t>(y));
    case kStep: return y >= x ? T{1} : T{0};
    case kClamp: return std::fmin(std::fmax(x, y), z);
    case kFma: return std::fma(x, y, z);
    case kLerp: {
      const T product = z * (y - x);
      return x + product;
    }
    case kMad: {
      const T product = x * y;
      return product + z;
    }
    case kSmoothstep: return SmoothstepOf(x, y, z);
    default: return FloatUnary(op, x);
  }
}

template <typename T>
Word FloatComponent(Intrinsic op, T x, T y, T z) {
  switch (op) {
    case Intrinsic::kIsFinite: return Truth(std::isfinite(x));
    case Intrinsic::kIsInf: return Truth(std::isinf(x));
    case Intrinsic::kIsNan: return Truth(std::isnan(x));
    case Intrinsic::kSign: return BitsOf(std::int32_t{x > 0} - std::int32_t{x < 0});
    default: return BitsOf(FloatFunction(op, x, y, z));
  }
}

std::uint32_t Reversed(std::uint32_t bits) {
  std::uint32_t result = 0;
  for (int i = 0; i < 32; ++i) result |= (bits >> i & 1u) << (31 - i);
  return result;
}

template <typename T>
Word IntegerComponent(Intrinsic op, T x, T y, T z) {
  using enum Intrinsic;
  using Unsigned = std::make_unsigned_t<T>;
  const auto bits = static_cast<Unsigned>(x);
  switch (op) {
    case kAbs: return x < 0 ? Unsigned{0 - bits} : bits;
    case kSign: return BitsOf(std::int32_t{x > 0} - std::int32_t{x < 0});
    case kMax: return BitsOf(std::max(x, y));
    case kMin: return BitsOf(std::min(x, y));
    case kClamp: return BitsOf(std::min(std::max(x, y), z));
    case kMad: return Unsigned{bits * static_cast<Unsigned>(y) + static_cast<Unsigned>(z)};
    case kNonUniform: return bits;
    case kCountBits: return static_cast<Word>(std::popcount(bits));
    case kFirstBitHigh: {
      // The place, from bit 0, of the first bit that differs from the sign; all ones if there is
      // none.
      const Unsigned differing = x < 0 ? Unsigned{~bits} : bits;
      return BitsOf(static_cast<std::int32_t>(std::bit_width(differing)) - 1);
    }
    case kFirstBitLow: return BitsOf(x == 0 ? -1 : std::countr_zero(bits));
    default: CLIPC_CHECK(op == kReverseBits); return Reversed(static_cast<std::uint32_t>(x));
  }
}

}  // namespace

template <typename T>
T PowOf(T base, T exponent) {
  const double x = base;
  const double y = exponent;
  if (x < 0 || (x == 0 && y == 0)) return std::numeric_limits<T>::quiet_NaN();
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<T>::quiet_NaN();
  return static_cast<T>(std::pow(std::fabs(x), y));
}
template float PowOf(float, float);
template double PowOf(double, double);

Word BinaryComponent(BinaryOp op, Scalar rep, Word left, Word right) {
  using enum Scalar;
  switch (rep) {
    case kFloat: return FloatBinary(op, FloatOf(left), FloatOf(right));
    case kDouble: return FloatBinary(op, DoubleOf(left), DoubleOf(right));
    case kInt: return IntegerBinary(op, IntOf(left), IntOf(right));
    case kUint: return IntegerBinary(op, UintOf(left), UintOf(right));
    case kInt64: return IntegerBinary(op, Int64Of(left), Int64Of(right));
    case kUint64: return IntegerBinary(op, left, right);
    default: return BoolBinary(op, left, right);
  }
}

Word UnaryComponent(UnaryOp op, Scalar rep, Word operand) {
  using enum UnaryOp;
  using enum Scalar;
  const bool is_32_bits = rep == kInt || rep == kUint;
  switch (op) {
    case kNot: return operand ^ 1;
    case kComplement: return is_32_bits ? UintOf(~operand) : ~operand;
    case kNegate:
      if (rep == kFloat) return BitsOf(-FloatOf(operand));
      if (rep == kDouble) return BitsOf(-DoubleOf(operand));
      return is_32_bits ? UintOf(0 - operand) : 0 - operand;
    case kPreIncrement:
    case kPostIncrement:
      return BinaryComponent(BinaryOp::kAdd, rep, operand, ConvertBits(1, kInt, rep));
    default: return BinaryComponent(BinaryOp::kSub, rep, operand, ConvertBits(1, kInt, rep));
  }
}

Word ComponentFunction(Intrinsic op, Scalar rep, Word x, Word y, Word z) {
  using enum Scalar;
  switch (rep) {
    case kFloat: return FloatComponent(op, FloatOf(x), FloatOf(y), FloatOf(z));
    case kDouble: return FloatComponent(op, DoubleOf(x), DoubleOf(y), DoubleOf(z));
    case kInt: return IntegerComponent(op, IntOf(x), IntOf(y), IntOf(z));
    case kUint: return IntegerComponent(op, UintOf(x), UintOf(y), UintOf(z));
    case kInt64: return IntegerComponent(op, Int64Of(x), Int64Of(y), Int64Of(z));
    default: return IntegerComponent(op, x, y, z);
  }
}

}  // namespace clipc::ir
