// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "backend-glsl/text.h"
#include "ir/program.h"

namespace clipc::glsl {

// How GLSL says an operator of HLSL.
struct Operator {
  std::string_view spelling;         // "+"
  std::string_view name;             // "add": for helper functions
  std::string_view vector_function;  // "lessThan": what compares vectors
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
// The number in every component of `expr`: of a literal, and of its conversion, negation or splat;
// of a zero. None for other expressions.
std::optional<Constant> ConstantOf(const ir::Program& program, ir::ExprId expr);

}  // namespace clipc::glsl
