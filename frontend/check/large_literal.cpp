// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/large_literal.h"

#include <cstdint>
#include <limits>
#include <optional>

namespace clipc::check {
namespace {

bool IsLarge(const Context& context, ExprId value) {
  return context.large_literals.contains(value.index);
}

// The number that the expression is, if it is an int literal, negated or not, or one that was
// noted.
std::optional<std::int64_t> NumberOf(const Context& context, ExprId value) {
  if (const auto* unary = context.GetIf<Unary>(value); unary && unary->op == UnaryOp::kNegate) {
    const bool is_int = context.Is<Literal>(unary->operand) && !IsLarge(context, unary->operand);
    const auto number = is_int ? NumberOf(context, unary->operand) : std::nullopt;
    return number ? std::optional(-*number) : std::nullopt;
  }
  const auto* literal = context.GetIf<Literal>(value);
  if (!literal) return std::nullopt;
  if (IsLarge(context, value)) return static_cast<std::int64_t>(literal->bits);
  if (context.TypeOf(value).scalar != Scalar::kInt) return std::nullopt;
  return static_cast<std::int32_t>(literal->bits);
}

// The literal of that value: an int if it is one, and one that is noted if not.
ExprId LiteralOf(Context& context, std::int64_t value, Span span) {
  using Int = std::numeric_limits<std::int32_t>;
  Builder at = context.At(span);
  if (value >= Int::min() && value <= Int::max()) return at.Int(static_cast<std::int32_t>(value));
  const bool is_uint = value > 0 && value <= std::numeric_limits<std::uint32_t>::max();
  const ExprId literal = is_uint ? at.Uint(static_cast<std::uint32_t>(value))
                                 : at.Add(context.types.Make(Scalar::kInt64),
                                          Literal{static_cast<std::uint64_t>(value)});
  NoteLargeLiteral(context, literal);
  return literal;
}

// The value of the operation; nullopt where it has none, or not with 64 bits.
std::optional<std::int64_t> Compute(BinaryOp op, std::int64_t left, std::int64_t right) {
  std::int64_t value = 0;
  bool is_lost = false;
  switch (op) {
    case BinaryOp::kAdd: is_lost = __builtin_add_overflow(left, right, &value); break;
    case BinaryOp::kSub: is_lost = __builtin_sub_overflow(left, right, &value); break;
    case BinaryOp::kMul: is_lost = __builtin_mul_overflow(left, right, &value); break;
    case BinaryOp::kDiv:
    case BinaryOp::kMod:
      is_lost = right == 0 || (left == std::numeric_limits<std::int64_t>::min() && right == -1);
      if (!is_lost) value = op == BinaryOp::kDiv ? left / right : left % right;
      break;
    default: return std::nullopt;
  }
  return is_lost ? std::nullopt : std::optional(value);
}

// Whether neither an int nor a uint has the bits of the literal, which stays as it is beside one.
bool IsBeyondWord(const Context& context, ExprId literal) {
  const auto number = NumberOf(context, literal);
  constexpr std::int64_t kWord = std::int64_t{1} << 32;
  return number && (*number >= kWord || *number <= -kWord);
}

// Makes a noted literal one of the other operand's type, where that decides.
void Adapt(Context& context, ExprId& literal, ExprId other) {
  if (!IsLarge(context, literal) || IsLarge(context, other)) return;
  const Scalar kind = context.TypeOf(other).scalar;
  const bool is_wide = kind == Scalar::kInt64;
  const bool is_word = kind == Scalar::kInt || kind == Scalar::kUint;
  if (!context.TypeOf(other).IsNumeric()) return;
  if (!is_wide && (!is_word || IsBeyondWord(context, literal))) return;
  const std::uint64_t bits = context.Get<Literal>(literal).bits;
  literal = context.At(context[literal].span)
                .Add(context.types.Make(kind),
                     Literal{is_wide ? bits : static_cast<std::uint32_t>(bits)});
}

}  // namespace

void NoteLargeLiteral(Context& context, ExprId value) {
  context.large_literals.insert(value.index);
}

ExprId NegateLarge(Context& context, ExprId operand, Span span) {
  if (!IsLarge(context, operand)) return {};
  const auto number = Compute(BinaryOp::kSub, 0, *NumberOf(context, operand));
  return number ? LiteralOf(context, *number, span) : ExprId{};
}

ExprId FoldLarge(Context& context, BinaryOp op, ExprId& left, ExprId& right, Span span) {
  if (!IsLarge(context, left) && !IsLarge(context, right)) return {};
  const auto one = NumberOf(context, left), other = NumberOf(context, right);
  if (one && other) {
    const auto value = Compute(op, *one, *other);
    return value ? LiteralOf(context, *value, span) : ExprId{};
  }
  AdaptLarge(context, left, right);
  return {};
}

void AdaptLarge(Context& context, ExprId& left, ExprId& right) {
  if (context.large_literals.empty()) return;
  Adapt(context, left, right);
  Adapt(context, right, left);
}

ExprId AdaptShifted(Context& context, ast::ExprId written, ExprId left, ExprId right) {
  const auto* sign = context.GetIf<ast::UnaryExpr>(written);
  const auto* literal = context.GetIf<ast::Literal>(sign ? sign->operand : written);
  const bool is_plain = literal && literal->kind != LiteralKind::kUint;
  const auto number = is_plain ? NumberOf(context, left) : std::nullopt;
  if (!number || context.TypeOf(right).scalar != Scalar::kUint || IsBeyondWord(context, left))
    return left;
  return context.At(context[left].span).Uint(static_cast<std::uint32_t>(*number));
}

void NoteLongLiteral(Context& context, ExprId value, double number) {
  context.long_literals.emplace(value.index, number);
}

ExprId DoubleOf(Context& context, ExprId value) {
  const auto* unary = context.GetIf<Unary>(value);
  const bool is_negated = unary && unary->op == UnaryOp::kNegate;
  const auto found = context.long_literals.find(is_negated ? unary->operand.index : value.index);
  if (found == context.long_literals.end()) return {};
  return context.At(context[value].span)
      .LiteralOf(Scalar::kDouble, is_negated ? -found->second : found->second);
}

}  // namespace clipc::check
