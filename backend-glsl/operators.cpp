// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/operators.h"

#include <variant>

#include "ir/access.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The operators in the order of BinaryOp.
constexpr Operator kOperators[] = {
    {"*", "multiply", "", Binding::kProduct},
    {"/", "divide", "", Binding::kProduct},
    {"%", "modulo", "", Binding::kProduct},
    {"+", "add", "", Binding::kSum},
    {"-", "subtract", "", Binding::kSum},
    {"<<", "shift_left", "", Binding::kShift},
    {">>", "shift_right", "", Binding::kShift},
    {"<", "less", "lessThan", Binding::kRelational},
    {">", "greater", "greaterThan", Binding::kRelational},
    {"<=", "less_equal", "lessThanEqual", Binding::kRelational},
    {">=", "greater_equal", "greaterThanEqual", Binding::kRelational},
    {"==", "equal_rows", "equal", Binding::kEquality},
    {"!=", "not_equal", "notEqual", Binding::kEquality},
    {"&", "bit_and", "", Binding::kBitAnd},
    {"^", "bit_xor", "", Binding::kBitXor},
    {"|", "bit_or", "", Binding::kBitOr},
    {"&&", "logical_and", "", Binding::kLogicalAnd},
    {"||", "logical_or", "", Binding::kLogicalOr},
    {"&&", "logical_and", "", Binding::kLogicalAnd},
    {"||", "logical_or", "", Binding::kLogicalOr},
};

}  // namespace

const Operator& OperatorOf(BinaryOp op) { return kOperators[static_cast<int>(op)]; }

std::optional<Constant> ConstantOf(const Program& program, ExprId expr) {
  const Scalar kind = program.types[program.exprs[expr].type].scalar;
  const auto& node = program.exprs[expr].node;
  if (const auto* literal = std::get_if<Literal>(&node)) return Constant{literal->bits, kind};
  if (std::holds_alternative<Zero>(node)) return Constant{0, kind};
  if (const auto* splat = std::get_if<Splat>(&node)) return ConstantOf(program, splat->operand);
  if (const auto* convert = std::get_if<Convert>(&node)) {
    const auto operand = ConstantOf(program, convert->operand);
    if (!operand) return std::nullopt;
    return Constant{ConvertBits(operand->bits, operand->kind, kind), kind};
  }
  const auto* unary = std::get_if<Unary>(&node);
  if (!unary || unary->op != UnaryOp::kNegate) return std::nullopt;
  const auto operand = ConstantOf(program, unary->operand);
  if (!operand || !IsFloat(kind)) return std::nullopt;
  const std::uint64_t sign = BaseOf(kind) == Scalar::kDouble ? std::uint64_t{1} << 63 : 1u << 31;
  return Constant{operand->bits ^ sign, kind};
}

bool AreInOrder(const std::optional<Constant>& low, const std::optional<Constant>& high) {
  return low && high && NumberOf(low->bits, low->kind) < NumberOf(high->bits, high->kind);
}

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
