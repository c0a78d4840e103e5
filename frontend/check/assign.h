// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "frontend/check/context.h"

// Assignment, and what may be assigned to.
namespace clipc::check {

void MarkConst(Context& context, ir::VarId var);
bool IsConstVar(const Context& context, ir::VarId var);
bool IsPath(const Context& context, ir::ExprId expr);
// Whether the expression can be assigned to; reports why not.
bool CheckTarget(Context& context, ir::ExprId target);
// The read of a writable object that a path of fields, indices and swizzles starts at, `buffer[i]`
// in `buffer[i].x`; none for other expressions.
ir::ExprId ElementIn(const Context& context, ir::ExprId expr);
// Makes the read a variable that holds what was read, in place; the result stores the variable.
ir::ExprId ChangeElement(Context& context, ir::ExprId element, std::vector<ir::ExprId>& prologue);
// The path with every index that does something replaced by a temporary, so that it can be cloned.
ir::ExprId Stabilize(Context& context, ir::ExprId path, std::vector<ir::ExprId>& prologue);
ir::ExprId CheckAssign(Context& context, const ast::AssignExpr& expr, Span span);
// target op= value. Where the operator works on another type than the target's: target = (T)(target
// op value).
ir::ExprId AssignCompound(Context& context, ast::BinaryOp op, ir::ExprId target, ir::ExprId value,
                          Span op_span, Span span);
// target = value, both of one type.
ir::ExprId StoreTo(Context& context, ir::ExprId target, ir::ExprId value, Span span);

}  // namespace clipc::check
