// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Literals without a suffix from profile 6.0 on. To DXC one is a number of 64 bits without a type,
// "literal int" or "literal float", which becomes what the other operand is: CombineBasicTypes in
// its SemaHLSL.cpp. An integer of 2^31 and more is a uint here where it is used alone and fits one,
// and a sum or the like of such literals is computed with 64 bits.
namespace clipc::check {

// Notes that the value is such a literal.
void NoteLargeLiteral(Context& context, ExprId value);
// The literal that `-operand` is, if the operand is a literal that was noted; else none.
ExprId NegateLarge(Context& context, ExprId operand, Span span);
// Makes a noted operand beside a value one of the value's type.
void AdaptLarge(Context& context, ExprId& left, ExprId& right);
// The uint that a literal is which is shifted by a uint: "For case like 1<<x" in
// CheckBinOpForHLSL of DXC's SemaHLSL.cpp. `written` is the literal in the text; other operands
// stay.
ExprId AdaptShifted(Context& context, ast::ExprId written, ExprId left, ExprId right);

// Notes that the float literal is `number`, which a float rounds.
void NoteLongLiteral(Context& context, ExprId value, double number);
// The double that a noted literal is, negated or not; none for all else.
ExprId DoubleOf(Context& context, ExprId value);

// The value of an operation of literals of which one was noted; none for other operations. A noted
// operand beside a value is adapted.
ExprId FoldLarge(Context& context, BinaryOp op, ExprId& left, ExprId& right, Span span);

}  // namespace clipc::check
