// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "frontend/check/context.h"
// Values: temporaries that hold them, conversions, and constants.
namespace clipc::check {

// A reference to a new temporary. The assignment of the value to it is added to `prologue`.
ExprId Hoist(Context& context, ExprId value, Exprs& prologue);
// The value itself when it is a path that may be cloned, else a reference to a temporary.
ExprId Repeatable(Context& context, ExprId value, Exprs& prologue);
// The value, with the steps of the prologue evaluated before it.
ExprId WithPrologue(Context& context, ExprSpan prologue, ExprId value);
// The value converted to `to` as HLSL does without a cast. Reports when there is no such
// conversion.
ExprId Implicit(Context& context, ExprId value, TypeId to);
// The value cast to `to`, without the warnings of an implicit conversion.
ExprId ConvertSilently(Context& context, ExprId value, TypeId to);
// Whether the expression is a constant for GLSL as well: it consists of literals and constants
// under operators without side effects.
bool IsConstantExpr(const Context& context, ExprId expr);
// An integer that the text determines. Nothing after an error, which was reported.
std::optional<std::int64_t> ConstantInteger(Context& context, ast::ExprId id);

}  // namespace clipc::check
