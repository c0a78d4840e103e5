// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/check/checker.h"

// Operators but assignment.
namespace clipc {
namespace {

std::string_view SpellingOf(ast::BinaryOp op) {
  constexpr std::string_view kSpellings[] = {"*", "/", "%",  "+",  "-",  "<<", ">>",
                                             "<", ">", "<=", ">=", "==", "!=", "&",
                                             "^", "|", "&&", "||", ","};
  return kSpellings[static_cast<std::size_t>(op)];
}

std::string_view SpellingOf(ast::UnaryOp op) {
  constexpr std::string_view kSpellings[] = {"+", "-", "!", "~", "++", "--", "++", "--"};
  return kSpellings[static_cast<std::size_t>(op)];
}

bool IsBitwise(ast::BinaryOp op) {
  return op == ast::BinaryOp::kBitAnd || op == ast::BinaryOp::kBitOr ||
         op == ast::BinaryOp::kBitXor;
}

bool IsShift(ast::BinaryOp op) {
  return op == ast::BinaryOp::kShiftLeft || op == ast::BinaryOp::kShiftRight;
}

// The two enums list the operators of the IR in the same order.
ir::BinaryOp ToIr(ast::BinaryOp op) { return static_cast<ir::BinaryOp>(op); }
static_assert(static_cast<int>(ast::BinaryOp::kLogicalOr) ==
              static_cast<int>(ir::BinaryOp::kLogicalOr));
static_assert(static_cast<int>(ast::BinaryOp::kEqual) == static_cast<int>(ir::BinaryOp::kEqual));

}  // namespace

ir::ExprId Checker::CheckUnary(const ast::UnaryExpr& expr, Span span) {
  if (expr.op >= ast::UnaryOp::kPreIncrement) return CheckIncrement(expr, span);
  const auto* literal = std::get_if<ast::Literal>(&file_.exprs[expr.operand].node);
  constexpr std::uint64_t kLeastInt = std::uint64_t{1} << 31;
  if (expr.op == ast::UnaryOp::kMinus && literal && literal->kind == LiteralKind::kInt &&
      literal->bits == kLeastInt) {
    return At(span).Int(std::numeric_limits<std::int32_t>::min());
  }
  ir::ExprId operand = CheckExpr(expr.operand);
  if (IsError(operand)) return operand;
  const ir::TypeId type = TypeIdOf(operand);
  if (!program_.types[type].IsNumeric()) {
    const ir::ExprId operands[] = {operand};
    if (const auto call = CallOperator(SpellingOf(expr.op), operands, span, span)) return *call;
    diagnostics_.Report(span, diag::BadOperand, SpellingOf(expr.op), TypeName(type));
    return ErrorExpr(span);
  }
  const ir::Scalar kind = program_.types[type].scalar;
  const auto as = [&](ir::Scalar wanted) {
    return Implicit(operand, program_.types.WithScalar(type, wanted));
  };
  switch (expr.op) {
    case ast::UnaryOp::kPlus: return kind == ir::Scalar::kBool ? as(ir::Scalar::kInt) : operand;
    case ast::UnaryOp::kMinus:
      if (kind == ir::Scalar::kBool) operand = as(ir::Scalar::kInt);
      return At(span).UnaryOf(ir::UnaryOp::kNegate, operand);
    case ast::UnaryOp::kNot: return At(span).UnaryOf(ir::UnaryOp::kNot, as(ir::Scalar::kBool));
    default:
      if (ir::IsFloat(kind)) {
        diagnostics_.Report(span, diag::IntegerNeeded, SpellingOf(expr.op), TypeName(type));
        return ErrorExpr(span);
      }
      if (kind == ir::Scalar::kBool) operand = as(ir::Scalar::kInt);
      return At(span).UnaryOf(ir::UnaryOp::kComplement, operand);
  }
}

ir::ExprId Checker::CheckIncrement(const ast::UnaryExpr& expr, Span span) {
  const ir::ExprId target = CheckExpr(expr.operand);
  if (IsError(target)) return target;
  const ir::TypeId type = TypeIdOf(target);
  const bool is_bool = program_.types[type].scalar == ir::Scalar::kBool;
  if (!program_.types[type].IsNumeric() || is_bool) {
    diagnostics_.Report(span, diag::BadOperand, SpellingOf(expr.op), TypeName(type));
    return ErrorExpr(span);
  }
  if (const ir::ExprId element = ElementIn(target)) {
    std::vector<ir::ExprId> steps;
    const ir::ExprId store = ChangeElement(element, steps);
    const int step = static_cast<int>(expr.op) - static_cast<int>(ast::UnaryOp::kPreIncrement);
    const auto op = static_cast<ir::UnaryOp>(static_cast<int>(ir::UnaryOp::kPreIncrement) + step);
    const ir::ExprId result = Hoist(At(span).UnaryOf(op, target), steps);
    steps.push_back(store);
    return WithPrologue(steps, result);
  }
  if (!CheckTarget(target)) return ErrorExpr(span);
  if (!std::holds_alternative<ir::MatrixSwizzle>(program_.exprs[target].node)) {
    // The four operators come in the same order, after three of the IR's and four of the tree's.
    const int step = static_cast<int>(expr.op) - static_cast<int>(ast::UnaryOp::kPreIncrement);
    const auto op = static_cast<ir::UnaryOp>(static_cast<int>(ir::UnaryOp::kPreIncrement) + step);
    return At(span).UnaryOf(op, target);
  }
  const bool adds =
      expr.op == ast::UnaryOp::kPreIncrement || expr.op == ast::UnaryOp::kPostIncrement;
  const bool is_post = expr.op >= ast::UnaryOp::kPostIncrement;
  std::vector<ir::ExprId> prologue;
  const ir::ExprId old = is_post ? Hoist(ir::Clone(program_, target), prologue) : ir::ExprId{};
  const ast::BinaryOp op = adds ? ast::BinaryOp::kAdd : ast::BinaryOp::kSub;
  const ir::ExprId changed = AssignCompound(op, target, At(span).Int(1), span, span);
  if (!is_post) return changed;
  prologue.push_back(changed);
  return WithPrologue(prologue, old);
}

ir::ExprId Checker::CheckBinary(const ast::BinaryExpr& expr, Span span) {
  const ir::ExprId left = CheckExpr(expr.left);
  const ir::ExprId right = CheckExpr(expr.right);
  if (IsError(left) || IsError(right)) return ErrorExpr(span);
  return CombineOperands(expr.op, left, right, expr.op_span, span);
}

// left op right, with the operands converted to what the operator works on.
ir::ExprId Checker::CombineOperands(ast::BinaryOp op, ir::ExprId left, ir::ExprId right,
                                    Span op_span, Span span) {
  if (op == ast::BinaryOp::kComma) return At(span).CommaOf(left, right);
  const bool is_numeric = TypeOf(left).IsNumeric() && TypeOf(right).IsNumeric();
  if (!is_numeric) {
    const ir::ExprId operands[] = {left, right};
    if (const auto call = CallOperator(SpellingOf(op), operands, op_span, span)) return *call;
  }
  if (op == ast::BinaryOp::kLogicalAnd || op == ast::BinaryOp::kLogicalOr) {
    return CombineLogical(op, left, right, op_span, span);
  }
  if (IsShift(op)) return CombineShift(op, left, right, op_span, span);
  const auto type = OperandType(op, left, right, op_span);
  if (!type) return ErrorExpr(span);
  left = Implicit(left, *type);
  right = Implicit(right, *type);
  if (IsError(left) || IsError(right)) return ErrorExpr(span);
  return At(span).BinaryOf(ToIr(op), left, right);
}

// The type both operands of a component-wise operator are converted to; nothing after an error,
// which was reported.
std::optional<ir::TypeId> Checker::OperandType(ast::BinaryOp op, ir::ExprId left, ir::ExprId right,
                                               Span op_span) {
  const bool is_numeric = TypeOf(left).IsNumeric() && TypeOf(right).IsNumeric();
  const auto type = is_numeric ? Common(TypeIdOf(left), TypeIdOf(right)) : std::nullopt;
  if (!type) {
    diagnostics_.Report(op_span, diag::OperandsMismatch, SpellingOf(op), TypeName(TypeIdOf(left)),
                        TypeName(TypeIdOf(right)));
    return std::nullopt;
  }
  const ir::Scalar kind = program_.types[*type].scalar;
  if ((IsBitwise(op) || IsShift(op)) && ir::IsFloat(kind)) {
    diagnostics_.Report(op_span, diag::IntegerNeeded, SpellingOf(op), TypeName(*type));
    return std::nullopt;
  }
  const bool takes_bools = op == ast::BinaryOp::kEqual || op == ast::BinaryOp::kNotEqual;
  if (kind == ir::Scalar::kBool && !takes_bools)
    return program_.types.WithScalar(*type, ir::Scalar::kInt);
  return type;
}

ir::ExprId Checker::CombineLogical(ast::BinaryOp op, ir::ExprId left, ir::ExprId right,
                                   Span op_span, Span span) {
  const auto shape = OperandType(op, left, right, op_span);
  if (!shape) return ErrorExpr(span);
  const ir::TypeId type = program_.types.WithScalar(*shape, ir::Scalar::kBool);
  left = Implicit(left, type);
  right = Implicit(right, type);
  if (IsError(left) || IsError(right)) return ErrorExpr(span);
  // HLSL 2021 evaluates the right side only when it matters; where it does nothing, both are the
  // same.
  const bool short_circuits = options_.profile.IsAtLeast(6, 0) &&
                              program_.types[type].kind == ir::TypeKind::kScalar &&
                              !ir::IsPure(program_, right);
  if (!short_circuits) return At(span).BinaryOf(ToIr(op), left, right);
  const bool is_and = op == ast::BinaryOp::kLogicalAnd;
  return At(span).BinaryOf(is_and ? ir::BinaryOp::kShortCircuitAnd : ir::BinaryOp::kShortCircuitOr,
                           left, right);
}

// The operands keep their kinds: the result is signed as the left one is.
ir::ExprId Checker::CombineShift(ast::BinaryOp op, ir::ExprId left, ir::ExprId right, Span op_span,
                                 Span span) {
  const auto shape = OperandType(op, left, right, op_span);
  if (!shape) return ErrorExpr(span);
  const auto as_operand = [&](ir::ExprId operand) {
    const ir::Scalar kind = TypeOf(operand).scalar;
    return Implicit(operand, program_.types.WithScalar(
                                 *shape, kind == ir::Scalar::kBool ? ir::Scalar::kInt : kind));
  };
  left = as_operand(left);
  right = as_operand(right);
  if (IsError(left) || IsError(right)) return ErrorExpr(span);
  return At(span).BinaryOf(ToIr(op), left, right);
}

// A user's operator (HLSL 2021) for operands of which one is a struct; nothing when there is none
// that fits.
std::optional<ir::ExprId> Checker::CallOperator(std::string_view op,
                                                std::span<const ir::ExprId> operands, Span op_span,
                                                Span span) {
  const auto found = operator_names_.find(op);
  if (found == operator_names_.end()) return std::nullopt;
  const Name name = found->second;
  if (const SymbolId member = FindMember(TypeIdOf(operands[0]), name)) {
    const std::vector<FunctionInfoId> overloads = OverloadsOf(member, TypeIdOf(operands[0]));
    const std::vector<ir::ExprId> arguments(operands.begin() + 1, operands.end());
    const Choice choice = ChooseOverload(overloads, arguments, name, op_span);
    if (choice.function)
      return CallFunction(choice.function, operands[0], arguments, op_span, span);
    if (choice.reported) return ErrorExpr(span);
  }
  if (const SymbolId symbol = FindUnqualified(name)) {
    const Choice choice = ChooseOverload(OverloadsOf(symbol, {}), operands, name, op_span);
    const std::vector<ir::ExprId> arguments(operands.begin(), operands.end());
    if (choice.function) return CallFunction(choice.function, {}, arguments, op_span, span);
    if (choice.reported) return ErrorExpr(span);
  }
  return std::nullopt;
}

}  // namespace clipc
