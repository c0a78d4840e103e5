// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"
// Constant buffers: cbuffer, tbuffer, $Globals, $Params, ConstantBuffer<T> and TextureBuffer<T>.
namespace clipc::check {

// Whether the variable is a ConstantBuffer<T> or TextureBuffer<T> of HLSL 5.1. A type of the user's
// with that name comes first.
bool IsConstantBuffer(const Context& context, const ast::VarDecl& var);
void ResolveConstantBuffer(Context& context, SymbolId id, const ast::VarDecl& var);
// Makes variables of all members of the buffer, once.
void ReachBuffer(Context& context, BufferId id);
// Adds the buffers that were reached to the program, in the order of the text.
void FinishBuffers(Context& context);

}  // namespace clipc::check
