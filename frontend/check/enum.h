// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

namespace clipc::check {

void DeclareEnum(Context& context, ast::DeclId id, const ast::EnumDecl& decl, ScopeId scope);
ir::TypeId EnumType(Context& context, const ast::EnumDecl& decl);
// All values of the enum `id`, in order; a value may use the ones before it.
void ResolveEnum(Context& context, SymbolId id, const ast::EnumDecl& decl);

}  // namespace clipc::check
