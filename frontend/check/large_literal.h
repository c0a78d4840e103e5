// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Decimal literals of 2^31 and more, and all of 2^32 and more, from profile 6.0 on. To DXC such a
// literal is a number of 64 bits without a type, "literal int", which becomes what the other
// operand is: CombineBasicTypes in its SemaHLSL.cpp. It is a uint here where it is used alone and
// fits one, and a sum or the like of literals is computed with 64 bits.
namespace clipc::check {

// Notes that the value is such a literal.
void NoteLargeLiteral(Context& context, ExprId value);
// The literal that `-operand` is, if the operand is a literal that was noted; else none.
ExprId NegateLarge(Context& context, ExprId operand, Span span);
// The value of an operation of literals of which one was noted; none for other operations. A noted
// operand beside a value becomes of the value's type.
ExprId FoldLarge(Context& context, BinaryOp op, ExprId& left, ExprId& right, Span span);

}  // namespace clipc::check
