// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Names: entering them, finding them, and what to say when they are not found.
namespace clipc::check {

// The scope a symbol opens: of a namespace, a struct, an enum, a typedef of one of them.
ScopeId ScopeOf(Context& context, SymbolId id);
// None when there is nothing of that name; nothing is reported.
SymbolId Find(Context& context, const ast::QualifiedName& name, bool types_only = false);
void ReportUndeclared(Context& context, Span span, const ast::QualifiedName& name, bool as_type,
                      bool as_function);
// A local, which reports one of the same name in the same scope.
SymbolId DeclareLocal(Context& context, SymbolKind kind, Name name, ast::DeclId decl, Span span);
void ReportRedefinition(Context& context, SymbolId older, Name name, Span span);

}  // namespace clipc::check
