// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "backend-glsl/text.h"
#include "ir/program.h"

namespace clipc::glsl {

// The GLSL form of a binary operator of HLSL.
struct Operator {
  std::string_view spelling;         // "+"
  std::string_view name;             // "add": for helper functions
  std::string_view vector_function;  // "lessThan": the function that compares vectors
  Binding binding;
};
const Operator& OperatorOf(ir::BinaryOp op);

inline bool IsLinear(ir::BinaryOp op) {
  return op == ir::BinaryOp::kMul || op == ir::BinaryOp::kDiv || op == ir::BinaryOp::kAdd ||
         op == ir::BinaryOp::kSub;
}

// A number that the program holds as a literal, as ir::Literal holds it.
struct Constant {
  std::uint64_t bits;
  ir::Scalar kind;
};
// Returns the number in every component of `expr`, if it is a zero, a literal, or a conversion, a
// splat or a negation of floats of such an expression; otherwise none.
std::optional<Constant> ConstantOf(const ir::Program& program, ir::ExprId expr);
// Whether both numbers are known, and the first is the smaller one.
bool AreInOrder(const std::optional<Constant>& low, const std::optional<Constant>& high);

// Whether an operand of a vector or matrix type is written as the scalar that each of its
// components is, where GLSL takes a scalar there.
bool IsOneScalar(const ir::Program& program, ir::ExprId operand);
// Whether the expression is short and has no effects, so that it may be written twice.
bool IsRepeatable(const ir::Program& program, ir::ExprId expr);

}  // namespace clipc::glsl
