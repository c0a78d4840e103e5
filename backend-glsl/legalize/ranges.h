// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <limits>

#include "ir/program.h"

namespace clipc::glsl {

// The least and the greatest value of an expression's components. A value whose range is known at
// both ends is not NaN.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();

  bool IsKnown() const { return least > -kLimit && most < kLimit; }
  bool IsWithin(double low, double high) const { return least >= low && most <= high; }

  // Sums and products of ranges within this stay finite in 32 bits, so that none is NaN.
  static constexpr double kLimit = 1e18;
};

// Bounds the values of an expression of numbers by its operators and constants. Inputs, uniforms
// and variables may have any value.
Range RangeOf(const ir::Program& program, ir::ExprId expr);

}  // namespace clipc::glsl
