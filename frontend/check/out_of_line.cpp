// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/out_of_line.h"

#include "frontend/check/context.h"
#include "frontend/check/scope.h"

namespace clipc::check {

KeptVector<ast::DeclId> OutOfLine::Of(Context& context, Name name, ScopeId scope) {
  const auto found = members_.find(name.index);
  if (found == members_.end()) return {};
  MemberDefinitions& member = found->second;
  const ViewSwitch in(context, {.scope = context.names.global()});
  // Looking at a struct may lead here again.
  while (member.placed < member.definitions.size()) {
    const Definition definition = member.definitions[member.placed++];
    const SymbolId type = Find(context, definition.owner, true);
    const SymbolId owner = type ? type : Find(context, definition.owner);
    const ScopeId of = owner ? ScopeOf(context, owner) : ScopeId{};
    if (of) member.by_scope[of.index].push_back(definition.decl);
  }
  return member.by_scope[scope.index];
}

}  // namespace clipc::check
