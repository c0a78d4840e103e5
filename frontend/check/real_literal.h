// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "frontend/check/context.h"

// Literals with a point and without a suffix from profile 6.0 on. To DXC one is a number of 64 bits
// without a type, "literal float" (LitFloatTy in its SemaExpr.cpp), and so is what operators make
// of such literals alone, until it becomes a value of another type. Here each is a float that also
// has its number; what 32 bits would compute otherwise is a literal of its own.
namespace clipc::check {

// The literal of a number without a suffix, which is a float unless it becomes a double.
ExprId RealLiteral(Context& context, double number, Span span);
// Notes that the float is the number of `from`, an expression made of literals alone; nothing if it
// is not one.
void NoteReal(Context& context, ExprId value, ExprId from);
// Notes that the value has its type for good: (float)0.1 is not a literal to DXC.
void NoteTyped(Context& context, ExprId value);
// The number that an operation of literals is, one of which has a point; nullopt for all else.
std::optional<double> RealOf(const Context& context, UnaryOp op, ExprId operand);
std::optional<double> RealOf(const Context& context, BinaryOp op, ExprId left, ExprId right);
// The value of an operation of such literals that floats would compute otherwise; none for others.
ExprId FoldReal(Context& context, UnaryOp op, ExprId operand, Span span);
ExprId FoldReal(Context& context, BinaryOp op, ExprId left, ExprId right, Span span);
// Notes the number of an operation of literals, which RealOf gave before.
void NoteRealNumber(Context& context, ExprId value, double number);
// The value, which becomes one of `to`: of the number itself if it is made of such literals alone,
// and a float does not become the same.
ExprId ExactFor(Context& context, ExprId value, TypeId to);
// Makes literals of either kind, beside values among the arguments of an intrinsic function, what
// the values are.
void AdaptArguments(Context& context, Exprs& arguments);
// Reports the literals that a float does not hold and that did not become anything else.
void ReportInfinite(Context& context);

}  // namespace clipc::check
