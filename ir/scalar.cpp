// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/scalar.h"

#include <cmath>
#include <limits>

namespace clipc::ir {
namespace {

template <typename Integer>
Integer Saturating(double value) {
  if (std::isnan(value)) return 0;
  // The limits are exact or rounded up to a power of two, so `>=` keeps the cast in range.
  if (value >= static_cast<double>(std::numeric_limits<Integer>::max()))
    return std::numeric_limits<Integer>::max();
  if (value <= static_cast<double>(std::numeric_limits<Integer>::min()))
    return std::numeric_limits<Integer>::min();
  return static_cast<Integer>(value);
}

bool IsSigned(Scalar base) { return base == Scalar::kInt || base == Scalar::kInt64; }

// The component, sign- or zero-extended to 64 bits.
std::uint64_t Widened(std::uint64_t bits, Scalar base) {
  if (base == Scalar::kInt) return static_cast<std::uint64_t>(std::int64_t{IntOf(bits)});
  return bits;
}

}  // namespace

std::int32_t ToInt(double value) { return Saturating<std::int32_t>(value); }
std::uint32_t ToUint(double value) { return Saturating<std::uint32_t>(value); }
std::int64_t ToInt64(double value) { return Saturating<std::int64_t>(value); }
std::uint64_t ToUint64(double value) { return Saturating<std::uint64_t>(value); }

double NumberOf(std::uint64_t bits, Scalar kind) {
  switch (BaseOf(kind)) {
    case Scalar::kFloat: return FloatOf(bits);
    case Scalar::kDouble: return DoubleOf(bits);
    case Scalar::kInt: return IntOf(bits);
    case Scalar::kInt64: return static_cast<double>(Int64Of(bits));
    default: return static_cast<double>(bits);
  }
}

std::uint64_t ConvertBits(std::uint64_t bits, Scalar from, Scalar to) {
  using enum Scalar;
  const Scalar source = BaseOf(from);
  const Scalar target = BaseOf(to);
  if (source == target) return bits;
  if (target == kBool) return NumberOf(bits, source) != 0 ? 1 : 0;
  if (!IsFloat(source)) {
    const std::uint64_t wide = Widened(bits, source);
    if (target == kInt || target == kUint) return UintOf(wide);
    if (target == kInt64 || target == kUint64) return wide;
    if (target == kDouble) return BitsOf(NumberOf(bits, source));
    // The integer is converted directly: by way of a double, a 64-bit value is rounded twice.
    return BitsOf(IsSigned(source) ? static_cast<float>(Int64Of(wide)) : static_cast<float>(wide));
  }
  const double value = NumberOf(bits, source);
  switch (target) {
    case kInt: return BitsOf(ToInt(value));
    case kUint: return ToUint(value);
    case kInt64: return static_cast<std::uint64_t>(ToInt64(value));
    case kUint64: return ToUint64(value);
    case kFloat: return BitsOf(static_cast<float>(value));
    default: return BitsOf(value);
  }
}

float HalfToFloat(std::uint32_t half) {
  const std::uint32_t sign = (half & 0x8000u) << 16;
  const std::uint32_t exponent = (half >> 10) & 0x1fu;
  const std::uint32_t mantissa = half & 0x3ffu;
  if (exponent == 0x1f) return std::bit_cast<float>(sign | 0x7f800000u | mantissa << 13);
  if (exponent != 0) return std::bit_cast<float>(sign | (exponent + 112) << 23 | mantissa << 13);
  const float magnitude = static_cast<float>(mantissa) * 0x1p-24f;
  return std::bit_cast<float>(sign | std::bit_cast<std::uint32_t>(magnitude));
}

std::uint32_t FloatToHalf(float value) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = bits >> 16 & 0x8000u;
  const float magnitude = std::fabs(value);
  if (std::isnan(value)) return sign | 0x7e00u | (bits >> 13 & 0x1ffu);
  if (magnitude >= 65520.0f) return sign | 0x7c00u;  // half way to 65536 and beyond
  if (magnitude < 0x1p-14f) {
    // Subnormal: a multiple of 2^-24; rounding up to 1024 of them is the smallest normal number.
    return sign | static_cast<std::uint32_t>(std::nearbyint(magnitude * 0x1p24f));
  }
  const std::uint32_t rounded = (bits & 0x7fffffffu) + 0xfffu + (bits >> 13 & 1u);
  return sign | ((rounded >> 13) - (112u << 10));
}

}  // namespace clipc::ir
