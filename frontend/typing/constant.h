// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "frontend/typing/names.h"

namespace clipc::typing {

// The value of a constant expression, as ir::ConstantBits finds it: component by component in the
// order of the type, bool and integers as themselves, floats as doubles of their float32 values.
// The kind of a struct or array is that of its first component.
struct Constant {
  Scalar kind;
  std::vector<double> components;
};
// The value of the expression; nullopt if the expression is not constant.
std::optional<Constant> EvaluateConstant(const Program& program, ExprId expr);
// The exact value of a constant integer or bool scalar; nullopt for any other expression.
std::optional<std::int64_t> EvaluateInteger(const Program& program, ExprId expr);
// Whether the expression is made of literals: int2(1, 2).
bool IsLiteralList(const Program& program, ExprId expr);

}  // namespace clipc::typing
