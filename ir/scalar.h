// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "ir/type.h"

// One component at compile time or in the evaluator, as Literal holds it: bool 0 or 1, int and uint
// in the low 32 bits (upper bits zero), float kinds as the bits of a float, double as the bits of a
// double.
namespace clipc::ir {

template <typename T>
std::uint64_t BitsOf(T value) {
  if constexpr (std::is_same_v<T, float>) {
    return std::bit_cast<std::uint32_t>(value);
  } else if constexpr (std::is_same_v<T, double>) {
    return std::bit_cast<std::uint64_t>(value);
  } else {
    return std::make_unsigned_t<T>(value);
  }
}
inline float FloatOf(std::uint64_t bits) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
}
inline double DoubleOf(std::uint64_t bits) { return std::bit_cast<double>(bits); }
inline std::int32_t IntOf(std::uint64_t bits) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(bits));
}
inline std::uint32_t UintOf(std::uint64_t bits) { return static_cast<std::uint32_t>(bits); }
inline std::int64_t Int64Of(std::uint64_t bits) { return static_cast<std::int64_t>(bits); }

// The functions truncate. NaN gives 0, and a value that does not fit gives the nearest one that
// does: ftoi and ftou of the Direct3D 11.3 functional specification.
std::int32_t ToInt(double value);
std::uint32_t ToUint(double value);
std::int64_t ToInt64(double value);
std::uint64_t ToUint64(double value);

// Converts one component as a Convert does.
std::uint64_t ConvertBits(std::uint64_t bits, Scalar from, Scalar to);
// The value as a number, for printing and comparing.
double NumberOf(std::uint64_t bits, Scalar kind);

// The value of the IEEE half in the low 16 bits of `half`; the upper 16 are ignored.
float HalfToFloat(std::uint32_t half);
// Rounds to the nearest half, ties to even; overflows to infinity; NaN stays NaN. Direct3D drivers
// round f32tof16 to the nearest or toward zero, so a comparison with a device takes values that a
// half holds exactly.
std::uint32_t FloatToHalf(float value);

}  // namespace clipc::ir
