// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "frontend/check/context.h"

// Variables outside functions: uniforms and their buffers, statics, resources.
namespace clipc::check {

// Works out what a variable is. False after an error, which was reported.
bool ResolveVar(Context& context, SymbolId id);
bool HoldsObjects(const Context& context, ir::TypeId type);
ir::VarId AddVar(Context& context, Name name, ir::TypeId type, ir::Storage storage, Span span);
// Where a declaration stands among those of namespaces.
std::uint32_t OrderOf(const Context& context, SymbolId id);
void ResolveStatic(Context& context, SymbolId id, const ast::VarDecl& var);
void ResolveObject(Context& context, SymbolId id, const ast::VarDecl& var, ir::TypeId type);
// The binding that counts under this profile.
const ast::RegisterBinding* BindingOf(const Context& context, List<ast::RegisterBinding> bindings,
                                      std::string_view letters);
void FinishGlobals(Context& context);

}  // namespace clipc::check
