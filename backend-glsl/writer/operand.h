// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "backend-glsl/operators.h"
#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"
#include "legalize/shape.h"

// Operators and calls of GLSL's functions, which take a scalar beside a vector in many places: an
// operand that is one scalar (IsOneScalar) is written so there, and in its whole shape elsewhere.
namespace clipc::glsl {

// Writes the operand where a scalar may stand for a vector or matrix.
Binding WriteOperand(Code& code, ir::ExprId operand);
void WriteOperandAt(Code& code, ir::ExprId operand, Binding least);
// Writes a value of the shape whose components all are `scalar`.
Binding WriteSplat(Code& code, const Shape& shape, ir::ExprId scalar);

Binding WriteOperator(Code& code, ir::UnaryOp op, ir::ExprId operand);
Binding WriteOperator(Code& code, ir::BinaryOp op, ir::ExprId left, ir::ExprId right);
// Writes the operand with another component kind.
Binding WriteConverted(Code& code, ir::Scalar kind, ir::ExprId operand);

// Writes the call function(arguments). Bit i of `scalars`: argument i may be a scalar beside
// vectors, if all such arguments are scalars.
Binding WriteCall(Code& code, std::string_view function, std::span<const ir::ExprId> arguments,
                  unsigned scalars = 0);

}  // namespace clipc::glsl
