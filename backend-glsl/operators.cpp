// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/operators.h"

#include "ir/access.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The operators in the order of BinaryOp.
constexpr Operator kOperators[] = {
    {"", Binding::kProduct},
    {"", Binding::kProduct},
    {"", Binding::kProduct},
    {"", Binding::kSum},
    {"", Binding::kSum},
    {"", Binding::kShift},
    {"", Binding::kShift},
    {"lessThan", Binding::kRelational},
    {"greaterThan", Binding::kRelational},
    {"lessThanEqual", Binding::kRelational},
    {"greaterThanEqual", Binding::kRelational},
    {"equal", Binding::kEquality},
    {"notEqual", Binding::kEquality},
    {"", Binding::kBitAnd},
    {"", Binding::kBitXor},
    {"", Binding::kBitOr},
    {"", Binding::kLogicalAnd},
    {"", Binding::kLogicalOr},
    {"", Binding::kLogicalAnd},
    {"", Binding::kLogicalOr},
};

}  // namespace

const Operator& OperatorOf(BinaryOp op) { return kOperators[static_cast<int>(op)]; }

bool IsOneScalar(const Program& program, ExprId operand) {
  return As<Zero>(program, operand) || As<Splat>(program, operand) || As<Literal>(program, operand);
}

bool IsRepeatable(const Program& program, ExprId expr) {
  const auto* index = As<Index>(program, expr);
  if (index && !As<Literal>(program, index->index)) return false;
  if (As<MatrixSwizzle>(program, expr)) return false;
  const ExprId whole = WholeOf(program, expr);
  return whole ? IsRepeatable(program, whole)
               : As<Literal>(program, expr) || As<VarRef>(program, expr);
}

}  // namespace clipc::glsl
