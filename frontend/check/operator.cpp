// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/operator.h"

#include <limits>

#include "frontend/check/assign.h"
#include "frontend/check/call.h"
#include "frontend/check/expr.h"
#include "frontend/check/function.h"
#include "frontend/check/overload.h"
#include "frontend/check/struct.h"
#include "frontend/check/value.h"

namespace clipc::check {
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

ir::ExprId CheckIncrement(Context& context, const ast::UnaryExpr& expr, Span span) {
  const ir::ExprId target = CheckExpr(context, expr.operand);
  if (context.IsError(target)) return target;
  const ir::Type& type = context.TypeOf(target);
  if (!type.IsNumeric() || type.scalar == ir::Scalar::kBool)
    return context.Fail(span, diag::BadOperand, SpellingOf(expr.op), context.TypeName(target));
  // The four operators have the same order in both enums.
  const int step = static_cast<int>(expr.op) - static_cast<int>(ast::UnaryOp::kPreIncrement);
  const auto op = static_cast<ir::UnaryOp>(static_cast<int>(ir::UnaryOp::kPreIncrement) + step);
  Exprs steps;
  if (const ir::ExprId element = ElementIn(context, target)) {
    const ir::ExprId store = ChangeElement(context, element, steps);
    const ir::ExprId result = Hoist(context, context.At(span).UnaryOf(op, target), steps);
    steps.push_back(store);
    return WithPrologue(context, steps, result);
  }
  if (!CheckTarget(context, target)) return context.ErrorExpr(span);
  if (!context.Is<ir::MatrixSwizzle>(target)) return context.At(span).UnaryOf(op, target);
  const bool adds =
      expr.op == ast::UnaryOp::kPreIncrement || expr.op == ast::UnaryOp::kPostIncrement;
  const bool is_post = expr.op >= ast::UnaryOp::kPostIncrement;
  const ir::ExprId old =
      is_post ? Hoist(context, ir::Clone(context.program, target), steps) : ir::ExprId{};
  const ir::ExprId changed =
      AssignCompound(context, adds ? ast::BinaryOp::kAdd : ast::BinaryOp::kSub, target,
                     context.At(span).Int(1), span);
  if (!is_post) return changed;
  steps.push_back(changed);
  return WithPrologue(context, steps, old);
}

// The operation, with each operand converted to its type.
ir::ExprId Combine(Context& context, ir::BinaryOp op, ir::ExprId left, ir::TypeId left_type,
                   ir::ExprId right, ir::TypeId right_type, Span span) {
  left = Implicit(context, left, left_type);
  right = Implicit(context, right, right_type);
  if (context.IsError(left, right)) return context.ErrorExpr(span);
  return context.At(span).BinaryOf(op, left, right);
}

ir::ExprId CombineLogical(Context& context, ast::BinaryOp op, ir::ExprId left, ir::ExprId right,
                          ir::TypeId shape, Span span) {
  const ir::TypeId type = context.types.WithScalar(shape, ir::Scalar::kBool);
  // HLSL 2021 evaluates the right side only when it matters, which shows only when it does
  // something.
  ir::BinaryOp wanted = ToIr(op);
  if (context.options.profile.IsAtLeast(6, 0) && context[type].kind == ir::TypeKind::kScalar &&
      !ir::IsPure(context.program, right)) {
    wanted = op == ast::BinaryOp::kLogicalAnd ? ir::BinaryOp::kShortCircuitAnd
                                              : ir::BinaryOp::kShortCircuitOr;
  }
  return Combine(context, wanted, left, type, right, type, span);
}

// The operands keep their kinds: the result is signed as the left one is.
ir::ExprId CombineShift(Context& context, ast::BinaryOp op, ir::ExprId left, ir::ExprId right,
                        ir::TypeId shape, Span span) {
  const auto type_of = [&](ir::ExprId operand) {
    const ir::Scalar kind = context.TypeOf(operand).scalar;
    return context.types.WithScalar(shape, kind == ir::Scalar::kBool ? ir::Scalar::kInt : kind);
  };
  return Combine(context, ToIr(op), left, type_of(left), right, type_of(right), span);
}

}  // namespace

ir::ExprId CheckUnary(Context& context, const ast::UnaryExpr& expr, Span span) {
  if (expr.op >= ast::UnaryOp::kPreIncrement) return CheckIncrement(context, expr, span);
  const auto* literal = context.GetIf<ast::Literal>(expr.operand);
  constexpr std::uint64_t kLeastInt = std::uint64_t{1} << 31;
  if (expr.op == ast::UnaryOp::kMinus && literal && literal->kind == LiteralKind::kInt &&
      literal->bits == kLeastInt) {
    return context.At(span).Int(std::numeric_limits<std::int32_t>::min());
  }
  ir::ExprId operand = CheckExpr(context, expr.operand);
  if (context.IsError(operand)) return operand;
  const ir::TypeId type = context.TypeIdOf(operand);
  if (!context[type].IsNumeric()) {
    const ir::ExprId operands[] = {operand};
    if (const auto call = CallOperator(context, SpellingOf(expr.op), operands, span, span))
      return *call;
    return context.Fail(span, diag::BadOperand, SpellingOf(expr.op), context.TypeName(type));
  }
  const ir::Scalar kind = context[type].scalar;
  const auto as = [&](ir::Scalar wanted) {
    return Implicit(context, operand, context.types.WithScalar(type, wanted));
  };
  switch (expr.op) {
    case ast::UnaryOp::kPlus: return kind == ir::Scalar::kBool ? as(ir::Scalar::kInt) : operand;
    case ast::UnaryOp::kMinus:
      if (kind == ir::Scalar::kBool) operand = as(ir::Scalar::kInt);
      return context.At(span).UnaryOf(ir::UnaryOp::kNegate, operand);
    case ast::UnaryOp::kNot:
      return context.At(span).UnaryOf(ir::UnaryOp::kNot, as(ir::Scalar::kBool));
    default:
      if (ir::IsFloat(kind)) {
        return context.Fail(span, diag::IntegerNeeded, SpellingOf(expr.op), context.TypeName(type));
      }
      if (kind == ir::Scalar::kBool) operand = as(ir::Scalar::kInt);
      return context.At(span).UnaryOf(ir::UnaryOp::kComplement, operand);
  }
}

ir::ExprId CheckBinary(Context& context, const ast::BinaryExpr& expr, Span span) {
  const ir::ExprId left = CheckExpr(context, expr.left);
  const ir::ExprId right = CheckExpr(context, expr.right);
  if (context.IsError(left, right)) return context.ErrorExpr(span);
  return CombineOperands(context, expr.op, left, right, expr.op_span, span);
}

ir::ExprId CombineOperands(Context& context, ast::BinaryOp op, ir::ExprId left, ir::ExprId right,
                           Span op_span, Span span) {
  if (op == ast::BinaryOp::kComma) return context.At(span).CommaOf(left, right);
  const bool is_numeric = context.TypeOf(left).IsNumeric() && context.TypeOf(right).IsNumeric();
  if (!is_numeric) {
    const ir::ExprId operands[] = {left, right};
    if (const auto call = CallOperator(context, SpellingOf(op), operands, op_span, span))
      return *call;
  }
  const auto type = OperandType(context, op, left, right, op_span);
  if (!type) return context.ErrorExpr(span);
  if (op == ast::BinaryOp::kLogicalAnd || op == ast::BinaryOp::kLogicalOr)
    return CombineLogical(context, op, left, right, *type, span);
  if (IsShift(op)) return CombineShift(context, op, left, right, *type, span);
  return Combine(context, ToIr(op), left, *type, right, *type, span);
}

std::optional<ir::TypeId> OperandType(Context& context, ast::BinaryOp op, ir::ExprId left,
                                      ir::ExprId right, Span op_span) {
  const bool is_numeric = context.TypeOf(left).IsNumeric() && context.TypeOf(right).IsNumeric();
  const auto type = is_numeric
                        ? CommonType(context.types, context.TypeIdOf(left), context.TypeIdOf(right))
                        : std::nullopt;
  if (!type) {
    context.Report(op_span, diag::OperandsMismatch, SpellingOf(op), context.TypeName(left),
                   context.TypeName(right));
    return std::nullopt;
  }
  const ir::Scalar kind = context[*type].scalar;
  if ((IsBitwise(op) || IsShift(op)) && ir::IsFloat(kind)) {
    context.Report(op_span, diag::IntegerNeeded, SpellingOf(op), context.TypeName(*type));
    return std::nullopt;
  }
  const bool takes_bools = op == ast::BinaryOp::kEqual || op == ast::BinaryOp::kNotEqual;
  if (kind == ir::Scalar::kBool && !takes_bools)
    return context.types.WithScalar(*type, ir::Scalar::kInt);
  return type;
}

std::optional<ir::ExprId> CallOperator(Context& context, std::string_view op, ExprSpan operands,
                                       Span op_span, Span span) {
  const auto found = context.functions.operators.find(op);
  if (found == context.functions.operators.end()) return std::nullopt;
  const Name name = found->second;
  if (const SymbolId member = FindMember(context, context.TypeIdOf(operands[0]), name)) {
    const std::vector<FunctionInfoId> overloads =
        OverloadsOf(context, member, context.TypeIdOf(operands[0]));
    const Exprs arguments(operands.begin() + 1, operands.end());
    const Choice choice = ChooseOverload(context, overloads, arguments, name, op_span);
    if (choice.function)
      return CallFunction(context, choice.function, operands[0], arguments, op_span, span);
    if (choice.reported) return context.ErrorExpr(span);
  }
  if (const SymbolId symbol = context.names.FindUnqualified(name)) {
    const Choice choice =
        ChooseOverload(context, OverloadsOf(context, symbol, {}), operands, name, op_span);
    const Exprs arguments(operands.begin(), operands.end());
    if (choice.function)
      return CallFunction(context, choice.function, {}, arguments, op_span, span);
    if (choice.reported) return context.ErrorExpr(span);
  }
  return std::nullopt;
}

}  // namespace clipc::check
