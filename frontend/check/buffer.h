// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"
// Constant buffers: cbuffer, tbuffer, $Globals, $Params, ConstantBuffer<T> and TextureBuffer<T>.
namespace clipc::check {

// Whether the variable is a ConstantBuffer<T> or TextureBuffer<T> of HLSL 5.1, unless a type of the
// user's has that name.
bool IsBufferObject(const Context& context, const ast::VarDecl& var);
// Whether the variable is a buffer of its own: a buffer object, or [[vk::push_constant]].
bool IsBuffer(const Context& context, const ast::VarDecl& var);
void ResolveBuffer(Context& context, SymbolId id, const ast::VarDecl& var);
// Makes variables of all members of the buffer, once.
void ReachBuffer(Context& context, BufferId id);
// Adds the buffers that were reached to the program, in the order of the text.
void FinishBuffers(Context& context);

}  // namespace clipc::check
