// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"
// Enums.
namespace clipc::check {

// Enters an enum and its enumerators, as locals if `scope` is none.
SymbolId DeclareEnum(Context& context, ast::DeclId id, const ast::EnumDecl& decl, ScopeId scope);
// The type that the values of the enum have.
TypeId EnumType(Context& context, const ast::EnumDecl& decl);
// Works out all values of the enum `id`, in order. A value may use the values before it.
void ResolveEnum(Context& context, SymbolId id, const ast::EnumDecl& decl);

}  // namespace clipc::check
