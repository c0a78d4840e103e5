// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "backend-glsl/target.h"
#include "ir/program.h"
#include "legalize/shape.h"

namespace clipc::glsl {

using legalize::Shape;

// A function that GLSL has under the same or another name.
struct BuiltinFunction {
  ir::Intrinsic op;
  std::string_view glsl;
  unsigned scalars = 0;      // bit i: argument i may be a scalar beside vectors
  bool is_rounding = false;  // the target needs Feature::kRounding
};
// Returns the function that the target has for a first argument of this shape; null if it has none.
const BuiltinFunction* BuiltinOf(ir::Intrinsic op, const Shape& shape, const Target& target);

}  // namespace clipc::glsl
