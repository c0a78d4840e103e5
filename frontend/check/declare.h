// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

#include "frontend/check/context.h"

// Entering declarations under their names, which resolves nothing yet.
namespace clipc::check {

void DeclareAll(Context& context, std::span<const ast::DeclId> decls, ScopeId scope);
void DeclareOne(Context& context, ast::DeclId id, ScopeId scope);
// Enters S if `type` is the `struct S {...}` of `struct S {...} x;`, part of another declaration.
void DeclareTypeInside(Context& context, ast::TypeId type, ScopeId scope);
// `using namespace a;` makes the names of `a` visible in the scope. `using a::b;` gives `b` a
// second name there.
void DeclareUsing(Context& context, const ast::UsingDecl& use, Span span, ScopeId scope);
// Reports `what`, which the version of the language does not have yet.
void ReportLanguage(Context& context, Span span, std::string_view what, LanguageVersion first);

}  // namespace clipc::check
