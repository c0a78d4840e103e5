// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "matrix.h"

/// Questions about several numbers at once. Not part of the public interface.
namespace clipc::runtime {

inline bool IsFinite(const Plane& plane) noexcept {
  return std::isfinite(plane.x) && std::isfinite(plane.y) && std::isfinite(plane.z) &&
         std::isfinite(plane.w);
}

inline bool IsFinite(const Matrix& matrix) noexcept {
  return std::all_of(&matrix.m[0][0], &matrix.m[0][0] + 16,
                     [](double element) { return std::isfinite(element); });
}

/// What underflow may take from a number, in units of 2^-53: half of the least double.
inline constexpr double kUnderflow = DBL_MIN;

/// The largest magnitude among the numbers.
inline double LargestOf(const double (&numbers)[4]) noexcept {
  return std::max(
      {std::fabs(numbers[0]), std::fabs(numbers[1]), std::fabs(numbers[2]), std::fabs(numbers[3])});
}

}  // namespace clipc::runtime
