// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "frontend/check/context.h"

// Initialisers. The way the braces of a list nest has no meaning in HLSL: the list is one row of
// components, which are dealt out to the components of the type in order.
namespace clipc::check {

// Returns the initialiser as a value of the type.
ExprId CheckInit(Context& context, ast::ExprId init, TypeId type);
// The size of the array in `T x[] = init`; `element` is T. Returns nullopt after an error, which
// was reported.
std::optional<std::uint32_t> ImpliedCount(Context& context, ast::ExprId init, TypeId element);

}  // namespace clipc::check
