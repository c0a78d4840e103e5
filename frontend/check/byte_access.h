// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Load and Store of byte address buffers for values of any type, as HLSL 2018 has them:
// buffer.Load<T>(address) and buffer.Store(address, value).
namespace clipc::check {

// Whether the call of a method of `object`, a texture, sampler or buffer, is one of those: it has a
// type argument, or it is a Store in a version of the language where its value may have any type.
bool IsTypedAccess(const Context& context, const ast::MemberExpr& member, ExprId object);

// Checks such a call. The value's scalars, vectors and columns of matrices follow each other in
// memory without padding; each becomes one load or store of words, in that order, and the address
// is evaluated once. Under CheckOptions::byte_matrices_by_row rows take the place of columns.
// Sources: DXC's RawBufferMethods.cpp and its tests buffer-agg-load-stores.hlsl.
ExprId CheckTypedAccess(Context& context, const ast::MemberExpr& member, ExprId object,
                        ExprSpan arguments, Span span);

}  // namespace clipc::check
