// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Names as they are written: their meanings, and the message if a name means nothing.
namespace clipc::check {

// The scope that a symbol opens, a namespace, a struct, an enum, or a typedef of one of them; none
// for other symbols.
ScopeId ScopeOf(Context& context, SymbolId id);
// The symbol that a name means; none if there is nothing of that name, which is not reported.
SymbolId Find(Context& context, const ast::QualifiedName& name, bool types_only = false);
// The functions of the name in other namespaces that are in one overload set with `first`, as
// `using namespace` makes it; each the newest of its scope.
std::vector<SymbolId> OtherFunctions(Context& context, const ast::QualifiedName& name,
                                     SymbolId first);
// Whether the name means one thing, or functions alone; reports if not.
bool IsOneThing(Context& context, Span span, const ast::QualifiedName& name,
                bool types_only = false);
// The use of a name.
enum class NameUse { kValue, kType, kFunction, kClipPlane };
// Reports a name that means nothing, with names that are spelt alike.
void ReportUndeclared(Context& context, Span span, const ast::QualifiedName& name, NameUse use);
// Declares a local. Reports another of the same name in the same block.
SymbolId DeclareLocal(Context& context, SymbolKind kind, Name name, ast::DeclId decl, Span span);
void ReportRedefinition(Context& context, SymbolId older, Name name, Span span);

}  // namespace clipc::check
