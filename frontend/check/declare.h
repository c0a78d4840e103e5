// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

#include "frontend/check/context.h"

// Entering the declarations of namespaces under their names; nothing is resolved yet.
namespace clipc::check {

void DeclareAll(Context& context, std::span<const ast::DeclId> decls, ScopeId scope);
void DeclareOne(Context& context, ast::DeclId id, ScopeId scope);
// `struct S {...} x;` declares S too.
void DeclareTypeInside(Context& context, ast::TypeId type, ScopeId scope);
// `using namespace a;` makes the names of `a` visible in this scope, `using a::b;` gives one of
// them a second home.
void DeclareUsing(Context& context, const ast::UsingDecl& use, Span span, ScopeId scope);

}  // namespace clipc::check
