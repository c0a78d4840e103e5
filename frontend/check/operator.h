// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string_view>

#include "frontend/check/context.h"

// Operators except assignment.
namespace clipc::check {

ExprId CheckNode(Context& context, const ast::UnaryExpr& expr, Span span);
ExprId CheckNode(Context& context, const ast::BinaryExpr& expr, Span span);
// The expression left op right, with the operands converted to the type that the operator works on.
ExprId CombineOperands(Context& context, BinaryOp op, ExprId left, ExprId right,
                       const UseSpans& spans);
// The type that both operands of a component-wise operator are converted to; nullopt after an
// error, which was reported.
std::optional<TypeId> OperandType(Context& context, BinaryOp op, ExprId left, ExprId right,
                                  Span op_span);
// A call of an operator that the user declared (HLSL 2021), for operands of which one is a struct;
// nullopt if no such operator fits.
std::optional<ExprId> CallOperator(Context& context, std::string_view op, ExprSpan operands,
                                   Span op_span, Span span);

}  // namespace clipc::check
