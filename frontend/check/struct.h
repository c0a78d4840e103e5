// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "frontend/check/context.h"

// Structs, their members and bases; enums.
namespace clipc::check {

ir::TypeId ResolveStruct(Context& context, ast::DeclId id, SymbolId symbol, ScopeId scope,
                         std::uint32_t order);
const StructInfo* InfoOf(const Context& context, ir::TypeId type);
SymbolId FindMember(const Context& context, ir::TypeId type, Name name);
// The number of a field of the struct; none when the struct has no such field.
std::optional<std::uint32_t> FindField(const Context& context, ir::TypeId type, Name name);
bool DerivesFrom(const Context& context, ir::TypeId derived, ir::TypeId base);
// A struct or enum defined inside a function.
void DeclareLocalType(Context& context, ast::DeclId id);

}  // namespace clipc::check
