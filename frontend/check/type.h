// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "frontend/check/context.h"

// From types as written to types of the program.
namespace clipc::check {

ir::TypeId ResolveType(Context& context, ast::TypeId id);
ir::TypeId ResolveNamedType(Context& context, const ast::Type& type);
ir::TypeId ResolveTypeSymbol(Context& context, SymbolId id);
// What the declaration of `id` sees: its scope, what stands before it, and itself.
View ContextOf(const Context& context, SymbolId id);
std::uint64_t ComponentsOf(const Context& context, ir::TypeId id);
int DepthOf(const Context& context, ir::TypeId id);
bool IsTooLarge(Context& context, ir::TypeId type, Span span);
// element[d0][d1]; `implied` is the size of a `[]` in front.
ir::TypeId ArrayOf(Context& context, ir::TypeId element, List<ast::ExprId> dimensions, Span span,
                   std::optional<std::uint32_t> implied = {});
ir::TypeId ResolveVarType(Context& context, const ast::VarDecl& var);
bool IsRowMajor(const Context& context, ast::Qualifiers qualifiers);
// The qualifiers of a variable, those of the typedef it is declared with included.
ast::Qualifiers QualifiersOf(Context& context, const ast::VarDecl& var);

}  // namespace clipc::check
