// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// A cast of a variable or of a part of one that is assigned to, (float3)v = x, or passed for an
// inout or out parameter, f((A)v). fxc accepts both: engines pass the vertex of one material to the
// functions of another.
namespace clipc::check {

// The path to a variable that `operand`, whose value is `value`, is or is cast from, if a cast of
// it to `type` can be written; none otherwise. Casts inside others change nothing: vkd3d's
// lhs-cast.shader_test, line 32, and lhs-partial-assignment.shader_test, line 115, checked against
// fxc.
ast::ExprId PathOfCast(const Context& context, ExprId value, ast::ExprId operand, TypeId type);
// Remembers that `value` is `operand`, which is a path to a variable, cast to another type.
void NoteCast(Context& context, ExprId value, ast::ExprId operand);
// The operand of the cast that made `value`; none if none did.
ast::ExprId CastOperand(const Context& context, ExprId value);
// Whether the components of a value of `type` can be written to `target`, which is assigned to
// through `cast`, or none in a call; reports if not.
bool CheckCastTarget(Context& context, ExprId target, ast::ExprId cast, TypeId type);
// The path v.xy of ((int4)v).xy, which fxc's 2.0 and 3.0 assign to; none of a value that is not a
// path.
ExprId WithoutCasts(Context& context, ExprId path);
// Adds to `steps` the assignments that write the components of `value`, a path that may be read
// several times, one after another into those of `target`, which has at least as many.
void StoreComponents(Context& context, ExprId target, ExprId value, Exprs& steps);

}  // namespace clipc::check
