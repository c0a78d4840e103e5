// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "ir/program.h"

namespace clipc::legalize {

// What the components of a float expression lie between; none of them is NaN.
struct FloatRange {
  double low = 0, high = 0;
};

// Knows the bounds of constants, of saturate and clamp, of a pixel's place on the screen, and of
// what arithmetic and rounding make of them; std::nullopt for every other expression.
std::optional<FloatRange> RangeOf(const ir::Program& program, ir::ExprId expr);

}  // namespace clipc::legalize
