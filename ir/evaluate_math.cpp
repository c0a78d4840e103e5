// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/evaluate_math.h"

#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include "base/invariant.h"
#include "ir/scalar.h"

namespace clipc::ir {
namespace {

Word Truth(bool value) { return value ? 1 : 0; }

// ---- operators

template <typename T>
Word Comparison(BinaryOp op, T left, T right) {
  switch (op) {
    case BinaryOp::kLess: return Truth(left < right);
    case BinaryOp::kGreater: return Truth(left > right);
    case BinaryOp::kLessEqual: return Truth(left <= right);
    case BinaryOp::kGreaterEqual: return Truth(left >= right);
    case BinaryOp::kEqual: return Truth(left == right);
    default: return Truth(left != right);
  }
}

bool IsComparison(BinaryOp op) { return op >= BinaryOp::kLess && op <= BinaryOp::kNotEqual; }

// One rounding for each operator: a product is stored before it is used.
template <typename T>
T TruncatedRemainder(T x, T y) {
  const T quotient = x / y;
  const T product = y * std::trunc(quotient);
  return x - product;
}

template <typename T>
Word FloatBinary(BinaryOp op, T left, T right) {
  if (IsComparison(op)) return Comparison(op, left, right);
  switch (op) {
    case BinaryOp::kMul: return BitsOf(left * right);
    case BinaryOp::kDiv: return BitsOf(left / right);
    case BinaryOp::kMod: return BitsOf(TruncatedRemainder(left, right));
    case BinaryOp::kAdd: return BitsOf(left + right);
    default: CLIPC_CHECK(op == BinaryOp::kSub); return BitsOf(left - right);
  }
}

template <typename Unsigned>
Unsigned UnsignedDivide(Unsigned left, Unsigned right, bool remainder) {
  if (right == 0) return std::numeric_limits<Unsigned>::max();
  return remainder ? left % right : left / right;
}

// udiv of the magnitudes, then the sign: the quotient is negative when the signs differ, the
// remainder has the dividend's.
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

template <typename Unsigned>
Unsigned IntegerBinary(BinaryOp op, Unsigned left, Unsigned right, bool is_signed) {
  using Signed = std::make_signed_t<Unsigned>;
  const Unsigned count = right & (std::numeric_limits<Unsigned>::digits - 1);
  switch (op) {
    case BinaryOp::kMul: return left * right;
    case BinaryOp::kDiv:
    case BinaryOp::kMod:
      return is_signed ? SignedDivide(left, right, op == BinaryOp::kMod)
                       : UnsignedDivide(left, right, op == BinaryOp::kMod);
    case BinaryOp::kAdd: return left + right;
    case BinaryOp::kSub: return left - right;
    case BinaryOp::kShiftLeft: return left << count;
    case BinaryOp::kShiftRight:
      return is_signed ? static_cast<Unsigned>(static_cast<Signed>(left) >> count) : left >> count;
    case BinaryOp::kBitAnd: return left & right;
    case BinaryOp::kBitXor: return left ^ right;
    default: CLIPC_CHECK(op == BinaryOp::kBitOr); return left | right;
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

// Through double: the result is rounded once, the same on every host.
template <typename T, typename F>
T Rounded(F function, T x) {
  return static_cast<T>(function(static_cast<double>(x)));
}

template <typename T>
T Transcendental(Intrinsic op, T value) {
  const double x = value;
  switch (op) {
    case Intrinsic::kAcos: return static_cast<T>(std::acos(x));
    case Intrinsic::kAsin: return static_cast<T>(std::asin(x));
    case Intrinsic::kAtan: return static_cast<T>(std::atan(x));
    case Intrinsic::kCos: return static_cast<T>(std::cos(x));
    case Intrinsic::kCosh: return static_cast<T>(std::cosh(x));
    case Intrinsic::kExp: return static_cast<T>(std::exp(x));
    case Intrinsic::kExp2: return static_cast<T>(std::exp2(x));
    case Intrinsic::kLog: return static_cast<T>(std::log(x));
    case Intrinsic::kLog10: return static_cast<T>(std::log10(x));
    case Intrinsic::kLog2: return static_cast<T>(std::log2(x));
    case Intrinsic::kRsqrt: return static_cast<T>(1 / std::sqrt(x));
    case Intrinsic::kSin: return static_cast<T>(std::sin(x));
    case Intrinsic::kSinh: return static_cast<T>(std::sinh(x));
    case Intrinsic::kTan: return static_cast<T>(std::tan(x));
    default: CLIPC_CHECK(op == Intrinsic::kTanh); return static_cast<T>(std::tanh(x));
  }
}

template <typename T>
T FloatUnary(Intrinsic op, T x) {
  switch (op) {
    case Intrinsic::kAbs: return std::fabs(x);
    case Intrinsic::kCeil: return std::ceil(x);
    case Intrinsic::kDegrees: return x * static_cast<T>(57.295779513082320877);
    case Intrinsic::kFloor: return std::floor(x);
    case Intrinsic::kFrac: return x - std::floor(x);
    case Intrinsic::kRadians: return x * static_cast<T>(0.017453292519943295769);
    case Intrinsic::kRcp: return 1 / x;
    case Intrinsic::kRound: return std::nearbyint(x);  // half to even in the default rounding mode
    case Intrinsic::kSaturate: return std::fmin(std::fmax(x, T{0}), T{1});  // fmax drops a NaN
    case Intrinsic::kSqrt: return std::sqrt(x);
    case Intrinsic::kTrunc: return std::trunc(x);
    default: return Transcendental(op, x);
  }
}

template <typename T>
T SmoothstepOf(T low, T high, T x) {
  const T t = FloatUnary(Intrinsic::kSaturate, (x - low) / (high - low));
  const T slope = 3 - 2 * t;
  return t * t * slope;
}

template <typename T>
T FloatFunction(Intrinsic op, T x, T y, T z) {
  switch (op) {
    case Intrinsic::kAtan2:
      return static_cast<T>(std::atan2(static_cast<double>(x), static_cast<double>(y)));
    case Intrinsic::kFmod: return TruncatedRemainder(x, y);
    case Intrinsic::kLdexp: return x * Rounded<T>([](double e) { return std::exp2(e); }, y);
    case Intrinsic::kMax: return std::fmax(x, y);  // of a number and NaN, the number
    case Intrinsic::kMin: return std::fmin(x, y);
    case Intrinsic::kPow: return PowOf(x, y);
    case Intrinsic::kStep: return y >= x ? T{1} : T{0};
    case Intrinsic::kClamp: return std::fmin(std::fmax(x, y), z);
    case Intrinsic::kFma: return std::fma(x, y, z);
    case Intrinsic::kLerp: {
      const T product = z * (y - x);
      return x + product;
    }
    case Intrinsic::kMad: {
      const T product = x * y;
      return product + z;
    }
    case Intrinsic::kSmoothstep: return SmoothstepOf(x, y, z);
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

template <typename Unsigned>
Word IntegerComponent(Intrinsic op, Unsigned x, Unsigned y, Unsigned z, bool is_signed) {
  using Signed = std::make_signed_t<Unsigned>;
  constexpr int digits = std::numeric_limits<Unsigned>::digits;
  const auto less = [&](Unsigned a, Unsigned b) {
    return is_signed ? static_cast<Signed>(a) < static_cast<Signed>(b) : a < b;
  };
  switch (op) {
    case Intrinsic::kAbs:
      return is_signed && static_cast<Signed>(x) < 0 ? static_cast<Unsigned>(0 - x) : x;
    case Intrinsic::kSign: return BitsOf(std::int32_t{less(0, x)} - std::int32_t{less(x, 0)});
    case Intrinsic::kMax: return less(x, y) ? y : x;
    case Intrinsic::kMin: return less(y, x) ? y : x;
    case Intrinsic::kClamp: {
      const Unsigned raised = less(x, y) ? y : x;
      return less(z, raised) ? z : raised;
    }
    case Intrinsic::kMad: return static_cast<Unsigned>(x * y + z);
    case Intrinsic::kCountBits: return static_cast<Word>(std::popcount(x));
    case Intrinsic::kFirstBitHigh: {
      // The place from bit 0 of the first bit that differs from the sign; none: all ones.
      const Unsigned bits = is_signed && static_cast<Signed>(x) < 0 ? static_cast<Unsigned>(~x) : x;
      return BitsOf(bits == 0 ? -1 : digits - 1 - std::countl_zero(bits));
    }
    case Intrinsic::kFirstBitLow: return BitsOf(x == 0 ? -1 : std::countr_zero(x));
    default:
      CLIPC_CHECK(op == Intrinsic::kReverseBits);
      return Reversed(static_cast<std::uint32_t>(x));
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
  switch (rep) {
    case Scalar::kFloat: return FloatBinary(op, FloatOf(left), FloatOf(right));
    case Scalar::kDouble: return FloatBinary(op, DoubleOf(left), DoubleOf(right));
    case Scalar::kInt:
      if (IsComparison(op)) return Comparison(op, IntOf(left), IntOf(right));
      return IntegerBinary(op, UintOf(left), UintOf(right), true);
    case Scalar::kUint:
      if (IsComparison(op)) return Comparison(op, UintOf(left), UintOf(right));
      return IntegerBinary(op, UintOf(left), UintOf(right), false);
    case Scalar::kInt64:
      if (IsComparison(op))
        return Comparison(op, static_cast<std::int64_t>(left), static_cast<std::int64_t>(right));
      return IntegerBinary(op, left, right, true);
    case Scalar::kUint64:
      if (IsComparison(op)) return Comparison(op, left, right);
      return IntegerBinary(op, left, right, false);
    default: return BoolBinary(op, left, right);
  }
}

Word UnaryComponent(UnaryOp op, Scalar rep, Word operand) {
  const bool is_32_bits = rep == Scalar::kInt || rep == Scalar::kUint;
  switch (op) {
    case UnaryOp::kNot: return operand ^ 1;
    case UnaryOp::kComplement: return is_32_bits ? UintOf(~operand) : ~operand;
    case UnaryOp::kNegate:
      if (rep == Scalar::kFloat) return BitsOf(-FloatOf(operand));
      if (rep == Scalar::kDouble) return BitsOf(-DoubleOf(operand));
      return is_32_bits ? UintOf(0 - operand) : 0 - operand;
    case UnaryOp::kPreIncrement:
    case UnaryOp::kPostIncrement:
      return BinaryComponent(BinaryOp::kAdd, rep, operand, ConvertBits(1, Scalar::kInt, rep));
    default:
      return BinaryComponent(BinaryOp::kSub, rep, operand, ConvertBits(1, Scalar::kInt, rep));
  }
}

Word ComponentFunction(Intrinsic op, Scalar rep, Word x, Word y, Word z) {
  switch (rep) {
    case Scalar::kFloat: return FloatComponent(op, FloatOf(x), FloatOf(y), FloatOf(z));
    case Scalar::kDouble: return FloatComponent(op, DoubleOf(x), DoubleOf(y), DoubleOf(z));
    case Scalar::kInt: return IntegerComponent(op, UintOf(x), UintOf(y), UintOf(z), true);
    case Scalar::kUint: return IntegerComponent(op, UintOf(x), UintOf(y), UintOf(z), false);
    case Scalar::kInt64: return IntegerComponent(op, x, y, z, true);
    default: return IntegerComponent(op, x, y, z, false);
  }
}

}  // namespace clipc::ir
