// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>

#include "frontend/check/context.h"

// Integer literals without a suffix from profile 6.0 on. To DXC one is a number of 64 bits without
// a type, "literal int", which becomes what the other operand is: CombineBasicTypes in its
// SemaHLSL.cpp. An integer of 2^31 and more is a uint here where it is used alone and fits one, an
// int64 where it does not, and what is made of such literals is computed with 64 bits.
// real_literal.h has the floats.
namespace clipc::check {

// Whether there are such literals, which the functions here need not be asked of otherwise.
inline bool HasUntyped(const Context& context) {
  return !context.int_literals.empty() || !context.real_literals.empty();
}

// The literal of such a number: an int if it is one.
ExprId IntLiteral(Context& context, std::int64_t number, Span span);
// Notes that the value is that number, made of such literals alone.
void NoteIntLiteral(Context& context, ExprId value, std::int64_t number);
// The number that an expression made of such literals alone is; nullopt for all else.
std::optional<std::int64_t> NumberOf(const Context& context, ExprId value);
// The number that an operation of such literals is; nullopt for other operations.
std::optional<std::int64_t> IntLiteralOf(const Context& context, UnaryOp op, ExprId operand);
std::optional<std::int64_t> IntLiteralOf(const Context& context, BinaryOp op, ExprId left,
                                         ExprId right);
// The value of an operation of such literals, one of which no int holds; none for other operations,
// and those that ints give. A literal that no int holds, beside a value, is adapted.
ExprId FoldLarge(Context& context, BinaryOp op, ExprId& left, ExprId& right, Span span);
// Makes a literal that no int holds, beside another operand that is a value, one of its type.
void Adapt(Context& context, ExprId& literal, ExprId other);
// The same of both operands.
void AdaptLarge(Context& context, ExprId& left, ExprId& right);
// The number of its lower 32 bits that the type holds. If more than a sign is lost, that is
// reported, as by Clang's -Wconstant-conversion.
std::int64_t TruncatedTo(Context& context, std::int64_t number, Scalar kind, Span span);
// The literal of the lower 32 bits of the number.
ExprId TruncateLiteral(Context& context, std::int64_t number, Scalar kind, Span span);
// The value, which becomes one of the kind, by a cast or not: a number that the expression does not
// have is a literal, of its lower 32 bits as above for an int or a uint.
ExprId SettleInt(Context& context, ExprId value, Scalar kind, bool is_cast);
// The uint that a literal is which is shifted by a uint: "For case like 1<<x" in
// CheckBinOpForHLSL of DXC's SemaHLSL.cpp. Other operands stay.
ExprId AdaptShifted(Context& context, ExprId left, ExprId right);

}  // namespace clipc::check
