// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "frontend/check/context.h"

namespace clipc::check {

// A fresh reference to a temporary that holds `value`.
ir::ExprId Hoist(Context& context, ir::ExprId value, std::vector<ir::ExprId>& prologue);
ir::ExprId WithPrologue(Context& context, std::span<const ir::ExprId> prologue, ir::ExprId value);
// The value as `to`, or what is wrong with that.
ir::ExprId Implicit(Context& context, ir::ExprId value, ir::TypeId to);
// Of one component, or where the user asked for it: nothing to warn of.
ir::ExprId ConvertSilently(Context& context, ir::ExprId value, ir::TypeId to);
// Whether GLSL, too, takes the expression for a constant: literals and constants under pure
// operators.
bool IsConstantExpr(const Context& context, ir::ExprId expr);
// An integer that the text fixes; nothing after an error, which was reported.
std::optional<std::int64_t> ConstantInteger(Context& context, ast::ExprId id);

}  // namespace clipc::check
