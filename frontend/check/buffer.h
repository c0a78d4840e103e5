// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

namespace clipc::check {

// ConstantBuffer<T> and TextureBuffer<T>, of HLSL 5.1, unless the user gave the name to something
// else.
bool IsConstantBuffer(const Context& context, const ast::VarDecl& var);
void ResolveConstantBuffer(Context& context, SymbolId id, const ast::VarDecl& var);
void ReachBuffer(Context& context, BufferId id);
void FinishBuffers(Context& context);

}  // namespace clipc::check
