// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/real_literal.h"

#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "frontend/check/large_literal.h"
#include "ir/scalar.h"

namespace clipc::check {
namespace {

std::optional<double> RealOf(const Context& context, ExprId value) {
  const auto found = context.real_literals.find(value.index);
  return found == context.real_literals.end() ? std::nullopt : std::optional(found->second);
}

// The number of a literal of either kind.
std::optional<double> LiteralNumber(const Context& context, ExprId value) {
  if (const auto number = RealOf(context, value)) return number;
  const auto number = NumberOf(context, value);
  return number ? std::optional(static_cast<double>(*number)) : std::nullopt;
}

// The value of the operation, computed with the bits of Real; nullopt for other operations.
template <typename Real>
std::optional<double> Compute(BinaryOp op, Real left, Real right) {
  switch (op) {
    case BinaryOp::kAdd: return left + right;
    case BinaryOp::kSub: return left - right;
    case BinaryOp::kMul: return left * right;
    case BinaryOp::kDiv: return left / right;
    case BinaryOp::kMod: return std::fmod(left, right);
    default: return std::nullopt;
  }
}

// Whether the comparison holds; nullopt for other operations.
std::optional<bool> Compare(BinaryOp op, double left, double right) {
  switch (op) {
    case BinaryOp::kLess: return left < right;
    case BinaryOp::kLessEqual: return left <= right;
    case BinaryOp::kGreater: return left > right;
    case BinaryOp::kGreaterEqual: return left >= right;
    case BinaryOp::kEqual: return left == right;
    case BinaryOp::kNotEqual: return left != right;
    default: return std::nullopt;
  }
}

float Rounded(double number) { return static_cast<float>(number); }

// Whether a float does not hold the number.
bool IsInfinite(double number) { return std::isinf(Rounded(number)) && !std::isinf(number); }

// Notes that a literal became something that its report as infinite is not about.
void ForgetInfinite(Context& context, ExprId value) {
  std::erase_if(context.infinite_literals, [&](const Context::InfiniteLiteral& infinite) {
    return infinite.literal == value;
  });
}

}  // namespace

ExprId RealLiteral(Context& context, double number, Span span) {
  const ExprId value = context.At(span).LiteralOf(Scalar::kFloat, number);
  NoteRealNumber(context, value, number);
  if (IsInfinite(number)) context.infinite_literals.push_back({value, number});
  return value;
}

void NoteRealNumber(Context& context, ExprId value, double number) {
  context.real_literals.emplace(value.index, number);
}

void NoteReal(Context& context, ExprId value, ExprId from) {
  if (const auto number = LiteralNumber(context, from)) NoteRealNumber(context, value, *number);
}

void NoteTyped(Context& context, ExprId value) {
  context.int_literals.erase(value.index);
  context.real_literals.erase(value.index);
}

std::optional<double> RealOf(const Context& context, UnaryOp op, ExprId operand) {
  const auto number = op == UnaryOp::kNegate ? RealOf(context, operand) : std::nullopt;
  return number ? std::optional(-*number) : std::nullopt;
}

std::optional<double> RealOf(const Context& context, BinaryOp op, ExprId left, ExprId right) {
  if (!RealOf(context, left) && !RealOf(context, right)) return std::nullopt;
  const auto one = LiteralNumber(context, left), other = LiteralNumber(context, right);
  return one && other ? Compute(op, *one, *other) : std::nullopt;
}

ExprId FoldReal(Context& context, UnaryOp op, ExprId operand, Span span) {
  const auto number = RealOf(context, op, operand);
  if (!number || !IsInfinite(*number)) return {};
  ForgetInfinite(context, operand);
  return RealLiteral(context, *number, span);
}

ExprId FoldReal(Context& context, BinaryOp op, ExprId left, ExprId right, Span span) {
  if (!RealOf(context, left) && !RealOf(context, right)) return {};
  const auto one = LiteralNumber(context, left), other = LiteralNumber(context, right);
  if (!one || !other) return {};
  const float one_rounded = Rounded(*one), other_rounded = Rounded(*other);
  ExprId folded;
  if (const auto number = Compute(op, *one, *other)) {
    const float rounded = Rounded(*Compute(op, one_rounded, other_rounded));
    if (Rounded(*number) == rounded || std::isnan(*number)) return {};
    folded = RealLiteral(context, *number, span);
  } else if (const auto holds = Compare(op, *one, *other)) {
    if (holds == Compare(op, one_rounded, other_rounded)) return {};
    folded = context.At(span).Bool(*holds);
  } else {
    return {};
  }
  ForgetInfinite(context, left);
  ForgetInfinite(context, right);
  return folded;
}

ExprId ExactFor(Context& context, ExprId value, TypeId to) {
  const Scalar kind = context[to].scalar;
  if (context.real_literals.empty() || !context[to].IsNumeric()) return value;
  const auto number = RealOf(context, value);
  if (!number || (IsFloat(kind) && kind != Scalar::kDouble)) return value;
  const bool is_same = ConvertBits(BitsOf(*number), Scalar::kDouble, kind) ==
                       ConvertBits(BitsOf(Rounded(*number)), Scalar::kFloat, kind);
  if (is_same && kind != Scalar::kDouble) return value;
  ForgetInfinite(context, value);
  return context.At(context[value].span).LiteralOf(kind, *number);
}

void AdaptArguments(Context& context, Exprs& arguments) {
  for (ExprId& argument : arguments) {
    for (const ExprId other : arguments) {
      Adapt(context, argument, other);
      if (IsFloat(context.TypeOf(other).scalar))
        argument = SettleInt(context, argument, Scalar::kFloat, false);
      if (context.TypeOf(other).scalar == Scalar::kDouble && context.TypeOf(argument).IsNumeric())
        argument = ExactFor(context, argument, context.TypeIdOf(other));
    }
  }
}

void ReportInfinite(Context& context) {
  for (const auto& [literal, number] : context.infinite_literals)
    context.Report(context[literal].span, diag::FloatLiteralRange, fmt::format("{}", number));
}

}  // namespace clipc::check
