// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "frontend/check/context.h"

// Structs: their members and bases.
namespace clipc::check {

// Makes a type of the struct declaration. `symbol` is its name; its members see `scope`, and
// symbols of namespaces before `order`.
TypeId ResolveStruct(Context& context, ast::DeclId id, SymbolId symbol, ScopeId scope,
                     std::uint32_t order);
// The checker's record of a struct type; null for other types.
const StructInfo* InfoOf(const Context& context, TypeId type);
// The member `name` of a struct or of its bases; none if it has no such member, and for types of
// another kind.
SymbolId FindMember(const Context& context, TypeId type, Name name);
// The number that the first field of `base`, the struct itself or a base of it, has in the struct;
// nullopt for other types.
std::optional<std::uint32_t> FirstFieldOf(const Context& context, TypeId type, TypeId base);
// The number in the struct of the field that `base` calls `name`: a struct may have a field of the
// same name. nullopt if there is none.
std::optional<std::uint32_t> FindField(const Context& context, TypeId type, TypeId base, Name name);
bool IsInterface(const Context& context, TypeId type);
bool DerivesFrom(const Context& context, TypeId derived, TypeId base);
// Declares a struct, typedef or enum inside a function.
void DeclareLocalType(Context& context, ast::DeclId id);

}  // namespace clipc::check
