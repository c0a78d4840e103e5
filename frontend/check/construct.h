// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Constructors: float4(a, b), float3x3(x, y, z), S(s).
namespace clipc::check {

ExprId CheckConstructor(Context& context, TypeId type, List<ast::ExprId> list, Span span);
// A component of the vector, vector.x for 0. A component of a swizzle is read from the vector or
// matrix itself.
ExprId Component(Context& context, ExprId vector, std::uint8_t component);
// Appends the components of the value to `scalars`, row by row, those of a struct or array part by
// part. The value is evaluated once, in `prologue` if need be.
void TakeApart(Context& context, ExprId value, Exprs& scalars, Exprs& prologue);

}  // namespace clipc::check
