// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "backend-glsl/text.h"
#include "ir/program.h"

namespace clipc::glsl {

// The GLSL form of a binary operator of HLSL, which has the same spelling.
struct Operator {
  std::string_view vector_function;  // "lessThan": the function that compares vectors
  Binding binding;
};
const Operator& OperatorOf(ir::BinaryOp op);

// Whether an operand of a vector or matrix type is written as the scalar that each of its
// components is, where GLSL takes a scalar there.
bool IsOneScalar(const ir::Program& program, ir::ExprId operand);
// Whether the expression is short and has no effects, so that it may be written twice.
bool IsRepeatable(const ir::Program& program, ir::ExprId expr);

}  // namespace clipc::glsl
