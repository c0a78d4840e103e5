// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "frontend/check/context.h"
// Values: temporaries that hold them, conversions, and constants.
namespace clipc::check {

// Returns a reference to a new temporary, and adds the assignment of the value to it to `prologue`.
ExprId Hoist(Context& context, ExprId value, Exprs& prologue);
// Returns the value itself if it is a path that may be cloned, otherwise a reference to a
// temporary.
ExprId Repeatable(Context& context, ExprId value, Exprs& prologue);
// The value, with the steps of the prologue evaluated before it.
ExprId WithPrologue(Context& context, ExprSpan prologue, ExprId value);
// The value converted to `to` as HLSL does without a cast. Reports if there is no such conversion.
ExprId Implicit(Context& context, ExprId value, TypeId to);
// The value cast to `to`, without the warnings of an implicit conversion.
ExprId ConvertSilently(Context& context, ExprId value, TypeId to);
// Whether the expression is a constant for GLSL as well: it consists of literals and constants
// under operators without side effects.
bool IsConstantExpr(const Context& context, ExprId expr);
// The value of an integer constant of the text; nullopt after an error, which was reported.
std::optional<std::int64_t> ConstantInteger(Context& context, ast::ExprId id);

}  // namespace clipc::check
