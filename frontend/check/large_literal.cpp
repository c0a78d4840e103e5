// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/large_literal.h"

#include <cstdint>
#include <limits>
#include <optional>

#include "ir/scalar.h"

namespace clipc::check {

std::optional<std::int64_t> NumberOf(const Context& context, ExprId value) {
  const auto found = context.int_literals.find(value.index);
  return found == context.int_literals.end() ? std::nullopt : std::optional(found->second);
}

namespace {

bool IsInt(std::int64_t number) { return number == static_cast<std::int32_t>(number); }

// Whether it is one that no int holds.
bool IsLarge(const Context& context, ExprId value) {
  const auto number = NumberOf(context, value);
  return number && !IsInt(*number);
}

// Whether an integer of the kind has the number.
bool Holds(Scalar kind, std::int64_t number) {
  if (IsUnsigned(kind)) return number >= 0 && (IsWide(kind) || number == UintOf(number));
  return IsWide(kind) || IsInt(number);
}
// Whether the expression has the number, and not its lower 32 bits alone.
bool IsExact(const Context& context, ExprId value) {
  const auto number = NumberOf(context, value);
  return !number || Holds(context.TypeOf(value).scalar, *number);
}
bool IsArithmetic(BinaryOp op) {
  return op == BinaryOp::kAdd || op == BinaryOp::kSub || op == BinaryOp::kMul ||
         op == BinaryOp::kDiv || op == BinaryOp::kMod;
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
    case BinaryOp::kBitAnd: value = left & right; break;
    case BinaryOp::kBitOr: value = left | right; break;
    case BinaryOp::kBitXor: value = left ^ right; break;
    case BinaryOp::kShiftLeft:
    case BinaryOp::kShiftRight:
      is_lost = right < 0 || right > 63;
      if (!is_lost && op == BinaryOp::kShiftRight) value = left >> right;
      if (!is_lost && op == BinaryOp::kShiftLeft)
        value = static_cast<std::int64_t>(static_cast<std::uint64_t>(left) << right);
      break;
    default: return std::nullopt;
  }
  return is_lost ? std::nullopt : std::optional(value);
}

// Whether the comparison holds; nullopt for other operations.
std::optional<bool> Compare(BinaryOp op, std::int64_t left, std::int64_t right) {
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

// Whether more than the upper 32 bits of a mask is lost with them: ~0xff000000 is -4278190081.
bool IsBeyondWord(std::int64_t number) {
  constexpr std::int64_t kWord = std::int64_t{1} << 32;
  return number >= kWord || number < -kWord;
}

}  // namespace

ExprId IntLiteral(Context& context, std::int64_t number, Span span) {
  const bool is_uint = number > 0 && number <= std::numeric_limits<std::uint32_t>::max();
  const Scalar kind = IsInt(number) ? Scalar::kInt : is_uint ? Scalar::kUint : Scalar::kInt64;
  const auto bits = static_cast<std::uint64_t>(number);
  const ExprId literal =
      context.At(span).Add(context.types.Make(kind), Literal{IsWide(kind) ? bits : UintOf(bits)});
  NoteIntLiteral(context, literal, number);
  return literal;
}

void NoteIntLiteral(Context& context, ExprId value, std::int64_t number) {
  context.int_literals.emplace(value.index, number);
}

std::optional<std::int64_t> IntLiteralOf(const Context& context, UnaryOp op, ExprId operand) {
  const auto number = NumberOf(context, operand);
  if (number && op == UnaryOp::kComplement) return ~*number;
  return number && op == UnaryOp::kNegate ? Compute(BinaryOp::kSub, 0, *number) : std::nullopt;
}

std::optional<std::int64_t> IntLiteralOf(const Context& context, BinaryOp op, ExprId left,
                                         ExprId right) {
  const auto one = NumberOf(context, left), other = NumberOf(context, right);
  return one && other ? Compute(op, *one, *other) : std::nullopt;
}

ExprId FoldLarge(Context& context, BinaryOp op, ExprId& left, ExprId& right, Span span) {
  if (!IsLarge(context, left) && !IsLarge(context, right)) return {};
  if (const auto number = IntLiteralOf(context, op, left, right)) {
    // Of what ints give the lower 32 bits are right.
    const bool is_right = op == BinaryOp::kShiftRight ? IsExact(context, left) : !IsArithmetic(op);
    return is_right ? ExprId{} : IntLiteral(context, *number, span);
  }
  const auto one = NumberOf(context, left), other = NumberOf(context, right);
  const auto holds = one && other ? Compare(op, *one, *other) : std::nullopt;
  if (holds) return context.At(span).Bool(*holds);
  if (!IsLogical(op)) AdaptLarge(context, left, right);
  return {};
}

void Adapt(Context& context, ExprId& literal, ExprId other) {
  if (!IsLarge(context, literal) || NumberOf(context, other)) return;
  const Type& type = context.TypeOf(other);
  if (!type.IsNumeric() || IsFloat(type.scalar)) return;
  const Scalar kind = type.scalar == Scalar::kBool ? Scalar::kInt : type.scalar;
  const Scalar own = context.TypeOf(literal).scalar;
  const bool is_word = !IsBeyondWord(*NumberOf(context, literal));
  if (is_word && (own == kind || (own == Scalar::kInt && kind == Scalar::kUint))) return;
  const Span span = context[literal].span;
  literal = IsWide(kind) ? context.At(span).Add(
                               context.types.Make(kind),
                               Literal{static_cast<std::uint64_t>(*NumberOf(context, literal))})
                         : TruncateLiteral(context, *NumberOf(context, literal), kind, span);
}

void AdaptLarge(Context& context, ExprId& left, ExprId& right) {
  if (context.int_literals.empty()) return;
  Adapt(context, left, right);
  Adapt(context, right, left);
}

std::int64_t TruncatedTo(Context& context, std::int64_t number, Scalar kind, Span span) {
  const std::int64_t left = IsUnsigned(kind) ? std::int64_t{UintOf(number)} : IntOf(number);
  if (IsBeyondWord(number))
    context.Report(span, diag::LiteralTruncated, number, NameOf(kind), left);
  return left;
}

ExprId TruncateLiteral(Context& context, std::int64_t number, Scalar kind, Span span) {
  const std::int64_t left = TruncatedTo(context, number, kind, span);
  return context.At(span).Add(context.types.Make(kind), Literal{UintOf(left)});
}

ExprId SettleInt(Context& context, ExprId value, Scalar kind, bool is_cast) {
  const auto number = NumberOf(context, value);
  if (!number || IsInt(*number)) return value;
  const Span span = context[value].span;
  const bool is_word = BaseOf(kind) == Scalar::kInt || BaseOf(kind) == Scalar::kUint;
  if (!is_word) return IsExact(context, value) ? value : IntLiteral(context, *number, span);
  return is_cast || !IsBeyondWord(*number) ? value : TruncateLiteral(context, *number, kind, span);
}

ExprId AdaptShifted(Context& context, ExprId left, ExprId right) {
  const auto number = NumberOf(context, left);
  if (!number || context.TypeOf(right).scalar != Scalar::kUint || NumberOf(context, right))
    return left;
  return TruncateLiteral(context, *number, Scalar::kUint, context[left].span);
}

}  // namespace clipc::check
