// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "frontend/check/context.h"

// Variables outside functions: uniforms, static variables and resources.
namespace clipc::check {

// Resolves the variable, once. Returns false after an error, which was reported.
bool ResolveVar(Context& context, SymbolId id);
// The initialiser of a variable: its own, or that of `int S::count = 1;` after a struct S with a
// `static int count`; none without one.
ast::ExprId InitOf(Context& context, SymbolId id, const ast::VarDecl& var);
// Whether the type is a texture, sampler or buffer, or an array of them.
bool HoldsObjects(const Context& context, TypeId type);
VarId AddVar(Context& context, Name name, TypeId type, Storage storage, Span span);
// The place of the symbol's declaration in the order of all declarations of namespaces; for a
// local, the place of the current view.
std::uint32_t OrderOf(const Context& context, SymbolId id);
void ResolveStatic(Context& context, SymbolId id, const ast::VarDecl& var);
// Adds the static variable of a numeric type, a struct or an array, with its initial value or none.
VarId AddStatic(Context& context, SymbolId id, const ast::VarDecl& var, TypeId type, ExprId init);
void ResolveObject(Context& context, SymbolId id, const ast::VarDecl& var, TypeId type);
// The register of the resource or buffer `name`: the register of the binding that counts, if there
// is one, and [[vk::binding]] among the attributes.
Register RegisterOf(Context& context, std::string_view name, List<ast::RegisterBinding> bindings,
                    List<ast::Attr> attributes, char letter);
// The binding of `name` with the letter, or without one, that counts under this profile; null if
// there is none. Reports two that say different things, unless nothing uses `name`.
const ast::RegisterBinding* BindingOf(Context& context, std::string_view name,
                                      List<ast::RegisterBinding> bindings, char letter,
                                      bool is_used = true);
// Reports the bindings of `name` with a letter that is not one of `letters`, the first of which is
// the one that it takes.
void CheckRegisterKinds(Context& context, std::string_view name,
                        List<ast::RegisterBinding> bindings, std::string_view letters);
// The number of the register: 4 for c3[1].
std::uint32_t NumberOf(Context& context, const ast::RegisterBinding& binding);
// Adds the static variables and resources that were reached to the program, in the order of the
// text.
void FinishGlobals(Context& context);

}  // namespace clipc::check
