// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "frontend/check/context.h"

// float4(a, b), float3x3(x, y, z)
namespace clipc::check {

ir::ExprId CheckConstructor(Context& context, ir::TypeId type, List<ast::ExprId> list, Span span);
// vector.x; a swizzle of a swizzle is one.
ir::ExprId Component(Context& context, ir::ExprId vector, std::uint8_t component);
// The components of a value, row by row; `value` is evaluated once.
void TakeApart(Context& context, ir::ExprId value, std::vector<ir::ExprId>& scalars,
               std::vector<ir::ExprId>& prologue);

}  // namespace clipc::check
