// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "frontend/check/context.h"

// Operators except assignment.
namespace clipc::check {

ir::ExprId CheckUnary(Context& context, const ast::UnaryExpr& expr, Span span);
ir::ExprId CheckBinary(Context& context, const ast::BinaryExpr& expr, Span span);
// left op right, with the operands converted to the type that the operator works on.
ir::ExprId CombineOperands(Context& context, ast::BinaryOp op, ir::ExprId left, ir::ExprId right,
                           Span op_span, Span span);
// The type that both operands of a component-wise operator are converted to. Nothing after an
// error, which was reported.
std::optional<ir::TypeId> OperandType(Context& context, ast::BinaryOp op, ir::ExprId left,
                                      ir::ExprId right, Span op_span);
// A call of an operator that the user declared (HLSL 2021), for operands of which one is a struct.
// Nothing when no such operator fits.
std::optional<ir::ExprId> CallOperator(Context& context, std::string_view op, ExprSpan operands,
                                       Span op_span, Span span);

}  // namespace clipc::check
