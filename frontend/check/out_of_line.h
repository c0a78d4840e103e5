// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/kept_blocks.h"
#include "frontend/check/symbols.h"
#include "frontend/parse/ast.h"

namespace clipc::check {

struct Context;

// The definitions of members outside of their structs: `int S::count = 1;`, `float S::f() {...}`.
class OutOfLine {
 public:
  void Add(Name member, const ast::QualifiedName& owner, ast::DeclId decl) {
    members_[member.index].definitions.push_back({owner, decl});
  }
  // The definitions of the member `name` of the struct that has this scope, in the order of the
  // text.
  KeptVector<ast::DeclId> Of(Context& context, Name name, ScopeId scope);

 private:
  struct Definition {
    ast::QualifiedName owner;
    ast::DeclId decl;
  };
  struct MemberDefinitions {
    KeptVector<Definition> definitions;
    std::size_t placed = 0;  // the number of definitions, from the first on, in by_scope
    KeptMap<std::uint32_t, KeptVector<ast::DeclId>> by_scope;
  };
  KeptMap<std::uint32_t, MemberDefinitions> members_;  // by Name
};

}  // namespace clipc::check
