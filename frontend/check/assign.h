// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Assignment: which expressions can be assigned to, and how each kind of target is written.
namespace clipc::check {

// Marks the variable as one that cannot be assigned to.
void MarkConst(Context& context, VarId var);
bool IsConstVar(const Context& context, VarId var);
// Returns whether the expression can be assigned to, and reports the reason if not. An index into a
// swizzle becomes an index into the vector.
bool CheckTarget(Context& context, ExprId target);
// Whether the expression is m._m00_m11[i], a component chosen at run time among several of a
// matrix, which CheckTarget accepts and GLSL does not.
bool IsChosenComponent(const Context& context, ExprId expr);
// Turns such an `element` into one of a variable that holds those components, so that it can be
// changed. Returns the store of the variable into the matrix, which belongs after the change; an
// error that was reported if nothing may be assigned to it. `prologue` must come before.
ExprId ChangeChosen(Context& context, ExprId element, Exprs& prologue);
// The path with every index that has side effects replaced by a temporary, so that the path can be
// cloned.
ExprId Stabilize(Context& context, ExprId path, Exprs& prologue);
// The target without the steps that come before it, which are added to `prologue`: the index of
// m[f()]._m00_m11 is computed once. Any other expression is returned as it is.
ExprId TakeSteps(const Context& context, ExprId target, Exprs& prologue);
// The target of an assignment or of `++i`, which is added to `prologue`: from shader model 6 on
// their results can be assigned to, as in C++. Any other expression is returned as it is.
ExprId TakeChanged(Context& context, ExprId target, Exprs& prologue);
// Checks an assignment `left = right` or `left op= right`.
ExprId CheckNode(Context& context, const ast::AssignExpr& expr, Span span);
// The assignment target op= value. If the operator works on another type than the target's, it is
// target = (T)(target op value).
ExprId AssignCompound(Context& context, BinaryOp op, ExprId target, ExprId value, Span span);
// The assignment target = value; both have the same type.
ExprId StoreTo(Context& context, ExprId target, ExprId value, Span span);

}  // namespace clipc::check
