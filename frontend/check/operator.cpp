// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/operator.h"

#include <limits>

#include "frontend/check/assign.h"
#include "frontend/check/bit_field.h"
#include "frontend/check/call.h"
#include "frontend/check/element.h"
#include "frontend/check/enum_class.h"
#include "frontend/check/expr.h"
#include "frontend/check/function.h"
#include "frontend/check/large_literal.h"
#include "frontend/check/overload.h"
#include "frontend/check/real_literal.h"
#include "frontend/check/struct.h"
#include "frontend/check/value.h"

namespace clipc::check {
namespace {

ExprId CheckIncrement(Context& context, UnaryOp op, ast::ExprId operand, Span span) {
  Exprs steps;
  const ExprId operand_steps = TakeSteps(context, CheckExpr(context, operand), steps);
  const ExprId target = TakeChanged(context, operand_steps, steps);
  if (context.IsError(target)) return target;
  const Type& type = context.TypeOf(target);
  if (!CheckNoEnumClass(context, SpellingOf(op), target, span)) return context.ErrorExpr(span);
  if (!type.IsNumeric() || type.scalar == Scalar::kBool)
    return context.Fail(span, diag::BadOperand, SpellingOf(op), context.TypeName(target));
  if (IsBitField(context, target)) return IncrementBits(context, op, target, span);
  if (const ExprId element = ElementIn(context, target)) {
    const Exprs stores = ChangeElement(context, element, target, false, steps);
    const ExprId result = Hoist(context, context.At(span).UnaryOf(op, target), steps);
    steps.insert(steps.end(), stores.begin(), stores.end());
    return WithPrologue(context, steps, result);
  }
  if (IsChosenComponent(context, target)) {
    const ExprId store = ChangeChosen(context, target, steps);
    if (context.IsError(store)) return store;
    const ExprId result = Hoist(context, context.At(span).UnaryOf(op, target), steps);
    steps.push_back(store);
    return WithPrologue(context, steps, result);
  }
  if (!CheckTarget(context, target)) return context.ErrorExpr(span);
  if (!context.Is<MatrixSwizzle>(target))
    return WithPrologue(context, steps, context.At(span).UnaryOf(op, target));
  const bool is_post = IsPostfix(op);
  const ExprId old = is_post ? Hoist(context, Clone(context.program, target), steps) : ExprId{};
  const ExprId changed = AssignCompound(context, IsIncrement(op) ? BinaryOp::kAdd : BinaryOp::kSub,
                                        target, context.At(span).Int(1), span);
  if (!is_post) return WithPrologue(context, steps, changed);
  steps.push_back(changed);
  return WithPrologue(context, steps, old);
}

// One side of an operator, and the type that it is converted to.
struct Side {
  ExprId value;
  TypeId type;
};

// The operation, with each operand converted to its type.
ExprId Combine(Context& context, BinaryOp op, const Side& left, const Side& right, Span span) {
  const ExprId converted_left = Implicit(context, left.value, left.type);
  const ExprId converted_right = Implicit(context, right.value, right.type);
  if (context.IsError(converted_left, converted_right)) return context.ErrorExpr(span);
  return context.At(span).BinaryOf(op, converted_left, converted_right);
}

// The operation of truths, with operands of a type that has its shape.
ExprId CombineLogical(Context& context, BinaryOp op, const Side& left, const Side& right,
                      Span span) {
  const TypeId type = context.types.WithScalar(left.type, Scalar::kBool);
  return Combine(context, op, {left.value, type}, {right.value, type}, span);
}

// From 6.0 on `&&` and `||` of scalars do not evaluate the right side where the left one says the
// result, which makes a difference only if that side has an effect.
void ShortCircuit(Context& context, ExprId expr) {
  const auto* logical = context.GetIf<Binary>(expr);
  const bool is_lazy = context.options.short_circuits && logical && IsLogical(logical->op) &&
                       context.TypeOf(expr).kind == TypeKind::kScalar &&
                       !IsPure(context.program, logical->right);
  if (!is_lazy) return;
  const bool is_and = logical->op == BinaryOp::kLogicalAnd;
  context.program.exprs[expr].node =
      Binary{is_and ? BinaryOp::kShortCircuitAnd : BinaryOp::kShortCircuitOr, logical->left,
             logical->right};
}

// The shift, whose operands keep their kinds: the result is signed as the left operand is.
ExprId CombineShift(Context& context, BinaryOp op, const Side& left, const Side& right, Span span) {
  const auto converted = [&](const Side& side) -> Side {
    const Scalar kind = context.TypeOf(side.value).scalar;
    return {side.value,
            context.types.WithScalar(side.type, kind == Scalar::kBool ? Scalar::kInt : kind)};
  };
  return Combine(context, op, converted(left), converted(right), span);
}

// The value of an operation of two int literals that is below the range of an int, which is the
// least int for fxc: vkd3d's sm1-const-folding.shader_test, line 104, where 3000000000 is the int
// -1294967296 and its double is -2147483648. None for other operations.
std::optional<std::int32_t> BelowInt(const Context& context, BinaryOp op, ExprId left,
                                     ExprId right) {
  const auto number = [&](ExprId side) -> std::optional<std::int64_t> {
    const auto* literal = context.GetIf<Literal>(side);
    if (!literal || context.TypeOf(side).scalar != Scalar::kInt) return std::nullopt;
    return static_cast<std::int32_t>(literal->bits);
  };
  if (context.program.profile.IsAtLeast(6, 0)) return std::nullopt;
  const auto a = number(left), b = number(right);
  if (!a || !b) return std::nullopt;
  constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
  const std::int64_t value = op == BinaryOp::kAdd   ? *a + *b
                             : op == BinaryOp::kSub ? *a - *b
                             : op == BinaryOp::kMul ? *a * *b
                                                    : 0;
  return value < kLeast ? std::optional(kLeast) : std::nullopt;
}

// The literal that an operation of a literal without a suffix is, where it is not an int or a float
// as well; none for other operations.
ExprId FoldUntyped(Context& context, UnaryOp op, ExprId operand, Span span) {
  const bool is_int = context.TypeOf(operand).scalar == Scalar::kInt;
  const auto number = IntLiteralOf(context, op, operand);
  if (number && op == UnaryOp::kNegate && !is_int) return IntLiteral(context, *number, span);
  return FoldReal(context, op, operand, span);
}

// Notes the number of an operation of one or two operands, if these are literals without a suffix.
template <typename Op, typename... Operands>
void NoteNumber(Context& context, ExprId result, Op op, Operands... operands) {
  if (const auto number = IntLiteralOf(context, op, operands...))
    NoteIntLiteral(context, result, *number);
  if (const auto number = RealOf(context, op, operands...))
    NoteRealNumber(context, result, *number);
}

}  // namespace

ExprId CheckNode(Context& context, const ast::UnaryExpr& expr, Span span) {
  if (expr.op && ChangesOperand(*expr.op))
    return CheckIncrement(context, *expr.op, expr.operand, span);
  const auto* literal = context.GetIf<ast::Literal>(expr.operand);
  constexpr std::uint64_t kLeastInt = std::uint64_t{1} << 31;
  if (expr.op == UnaryOp::kNegate && literal && literal->kind == LiteralKind::kInt &&
      literal->bits == kLeastInt && !context.program.profile.IsAtLeast(6, 0)) {
    return context.At(span).Int(std::numeric_limits<std::int32_t>::min());
  }
  ExprId operand = CheckExpr(context, expr.operand);
  if (context.IsError(operand)) return operand;
  const bool is_untyped = expr.op && HasUntyped(context);
  if (is_untyped) {
    if (const ExprId folded = FoldUntyped(context, *expr.op, operand, span)) return folded;
  }
  const TypeId type = context.TypeIdOf(operand);
  const std::string_view spelling = expr.op ? SpellingOf(*expr.op) : "+";
  if (!CheckNoEnumClass(context, spelling, operand, span)) return context.ErrorExpr(span);
  if (!context[type].IsNumeric()) {
    const ExprId operands[] = {operand};
    if (const auto call = CallOperator(context, spelling, operands, span, span)) return *call;
    return context.Fail(span, diag::BadOperand, spelling, context.TypeName(type));
  }
  const Scalar kind = context[type].scalar;
  if (expr.op == UnaryOp::kComplement && IsFloat(kind))
    return context.Fail(span, diag::IntegerNeeded, spelling, context.TypeName(type));
  const Scalar wanted = expr.op == UnaryOp::kNot ? Scalar::kBool
                        : kind == Scalar::kBool  ? Scalar::kInt
                                                 : kind;
  operand = Implicit(context, operand, context.types.WithScalar(type, wanted));
  if (!expr.op) return operand;
  const ExprId result = context.At(span).UnaryOf(*expr.op, operand);
  if (is_untyped) NoteNumber(context, result, *expr.op, operand);
  return result;
}

ExprId CheckNode(Context& context, const ast::BinaryExpr& expr, Span span) {
  ExprId left = CheckExpr(context, expr.left);
  const ExprId right = CheckExpr(context, expr.right);
  if (context.IsError(left, right)) return context.ErrorExpr(span);
  const std::string_view spelling = SpellingOf(expr.op);
  const bool fits = IsComparison(expr.op)
                        ? CheckEnumClasses(context, left, right, expr.op_span)
                        : CheckNoEnumClass(context, spelling, left, expr.op_span) &&
                              CheckNoEnumClass(context, spelling, right, expr.op_span);
  if (!fits) return context.ErrorExpr(span);
  if (IsLogical(expr.op) && context.options.short_circuits) {
    const bool is_and = expr.op == BinaryOp::kLogicalAnd;
    for (const ExprId side : {left, right}) {
      if (context.TypeOf(side).Components() <= 1) continue;
      return context.Fail(expr.op_span, diag::NeedsScalars, SpellingOf(expr.op),
                          context.TypeName(side), is_and ? "and(a, b)" : "or(a, b)");
    }
  }
  if (IsShift(expr.op) && HasUntyped(context)) left = AdaptShifted(context, left, right);
  const ExprId combined = CombineOperands(context, expr.op, left, right, {expr.op_span, span});
  ShortCircuit(context, combined);
  return combined;
}

ExprId CombineOperands(Context& context, BinaryOp op, ExprId left, ExprId right,
                       const UseSpans& spans) {
  const auto [op_span, span] = spans;
  const bool is_numeric = context.TypeOf(left).IsNumeric() && context.TypeOf(right).IsNumeric();
  if (!is_numeric) {
    const ExprId operands[] = {left, right};
    if (const auto call = CallOperator(context, SpellingOf(op), operands, op_span, span))
      return *call;
  }
  if (HasUntyped(context)) {
    if (const ExprId folded = FoldLarge(context, op, left, right, span)) return folded;
    if (const ExprId folded = FoldReal(context, op, left, right, span)) return folded;
  }
  const auto type = OperandType(context, op, left, right, op_span);
  if (!type) return context.ErrorExpr(span);
  if (const auto least = BelowInt(context, op, left, right)) return context.At(span).Int(*least);
  const Side sides[] = {{left, *type}, {right, *type}};
  const auto combine = IsLogical(op) ? CombineLogical : IsShift(op) ? CombineShift : Combine;
  const ExprId combined = combine(context, op, sides[0], sides[1], span);
  if (HasUntyped(context)) NoteNumber(context, combined, op, left, right);
  return combined;
}

std::optional<TypeId> OperandType(Context& context, BinaryOp op, ExprId left, ExprId right,
                                  Span op_span) {
  const bool is_numeric = context.TypeOf(left).IsNumeric() && context.TypeOf(right).IsNumeric();
  const auto type = is_numeric
                        ? CommonType(context.types, context.TypeIdOf(left), context.TypeIdOf(right))
                        : std::nullopt;
  if (!type) {
    Diagnostic& report = context.Report(op_span, diag::OperandsMismatch, SpellingOf(op),
                                        context.TypeName(left), context.TypeName(right));
    const auto is_kind = [&](ExprId id, TypeKind kind) { return context.TypeOf(id).kind == kind; };
    const bool has_matrix = is_kind(left, TypeKind::kMatrix) || is_kind(right, TypeKind::kMatrix);
    if (op == BinaryOp::kMul && is_numeric && has_matrix)
      report.Note(op_span, diag::MulMultipliesMatrices);
    return std::nullopt;
  }
  const Scalar kind = context[*type].scalar;
  if ((IsBitwise(op) || IsShift(op)) && IsFloat(kind)) {
    context.Report(op_span, diag::IntegerNeeded, SpellingOf(op), context.TypeName(*type));
    return std::nullopt;
  }
  const bool takes_bools = op == BinaryOp::kEqual || op == BinaryOp::kNotEqual;
  if (kind == Scalar::kBool && !takes_bools) return context.types.WithScalar(*type, Scalar::kInt);
  return type;
}

std::optional<ExprId> CallOperator(Context& context, std::string_view op, ExprSpan operands,
                                   Span op_span, Span span) {
  const auto found = context.functions.operators.find(op);
  if (found == context.functions.operators.end()) return std::nullopt;
  const Name name = found->second;
  const auto call = [&](SymbolId symbol, TypeId self, ExprId object,
                        ExprSpan arguments) -> std::optional<ExprId> {
    if (!symbol) return std::nullopt;
    const Choice choice =
        ChooseOverload(context, OverloadsOf(context, symbol, self), arguments, name, op_span);
    if (choice.function) {
      return CallFunction(context, choice.function, object,
                          Exprs(arguments.begin(), arguments.end()), {op_span, span});
    }
    return choice.reported ? std::optional(context.ErrorExpr(span)) : std::nullopt;
  };
  const TypeId type = context.TypeIdOf(operands[0]);
  const auto method = call(FindMember(context, type, name), type, operands[0], operands.subspan(1));
  return method ? method : call(context.names.FindUnqualified(name), {}, {}, operands);
}

}  // namespace clipc::check
