// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "frontend/check/context.h"

// Initialisers. HLSL does not care how the braces of a list nest: the list is one row of
// components, dealt out to the components of the type in order.
namespace clipc::check {

ir::ExprId CheckInit(Context& context, ast::ExprId init, ir::TypeId type);
// The size of `T x[] = init`.
std::optional<std::uint32_t> ImpliedCount(Context& context, ast::ExprId init, ir::TypeId element);

}  // namespace clipc::check
