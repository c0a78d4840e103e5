// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ir/program.h"

namespace clipc {

// The value of a constant expression, component by component in the order of the type (bool and
// integers as themselves, floats as doubles of their float32 values); nothing when the expression
// is not constant, which an integer division by zero is not. Sees through kConstant variables. A
// struct or array has the kind of its first component. Takes time linear in the expression; what it
// reads out of variables is bounded.
struct Constant {
  ir::Scalar kind;
  std::vector<double> components;
};
std::optional<Constant> EvaluateConstant(const ir::Program& program, ir::ExprId expr);
// The value of a constant integer or bool scalar, exactly.
std::optional<std::int64_t> EvaluateInteger(const ir::Program& program, ir::ExprId expr);

}  // namespace clipc
