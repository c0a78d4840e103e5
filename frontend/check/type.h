// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <span>

#include "frontend/check/context.h"

// Types as they are written, resolved to types of the program.
namespace clipc::check {

TypeId ResolveType(Context& context, ast::TypeId id);
TypeId ResolveNamedType(Context& context, const ast::Type& type);
// The type that a symbol of kind kType names.
TypeId ResolveTypeSymbol(Context& context, SymbolId id);
// The view from the declaration of the symbol: its scope, the declarations before it, and itself.
View ViewOf(const Context& context, SymbolId id);
// The number of components of a value of the type, at most one more than is allowed.
std::uint64_t ComponentsOf(const Context& context, TypeId id);
// The number of fields of the struct that the type is or is an array of, those of their own structs
// included.
std::uint64_t FieldsOf(const Context& context, TypeId id);
// The number of levels of structs and arrays in the type.
int DepthOf(const Context& context, TypeId id);
// Whether the type has too many components, fields or levels, which is reported.
bool IsTooLarge(Context& context, TypeId type, Span span);
// An empty first `[]`: the size that the variable's value has, which a buffer does not need.
struct OpenDimension {
  std::optional<std::uint32_t> implied = {};
  bool is_buffer = false;
};
// The type element[d0][d1].
TypeId ArrayOf(Context& context, TypeId element, List<ast::ExprId> dimensions, Span span,
               const OpenDimension& open = {});
TypeId ArrayOf(Context& context, TypeId element, std::span<const ast::ExprId> dimensions, Span span,
               const OpenDimension& open = {});
// The type of the variable, with its dimensions.
TypeId ResolveVarType(Context& context, const ast::VarDecl& var);
// Returns `type`; if it is made of strings, reports and returns the error type.
TypeId WithoutString(Context& context, TypeId type, const ast::VarDecl& var);
// Whether matrices lie row by row in memory.
bool IsRowMajor(const Context& context, ast::Qualifiers qualifiers);
// The qualifiers of the variable and of the typedef that names its type.
ast::Qualifiers QualifiersOf(Context& context, const ast::VarDecl& var);
// Whether the type of the variable is a patch of control points.
bool IsPatch(Context& context, const ast::VarDecl& var);
// The name of the patch that the variable is, InputPatch or OutputPatch; empty if it is not one.
std::string_view PatchName(Context& context, const ast::VarDecl& var);
// The qualifiers that say how matrices lie in the elements of the buffer `var`: those of its
// template argument and of the typedef that names it, and the pragma of the variable.
ast::Qualifiers ElementQualifiersOf(Context& context, const ast::VarDecl& var);

}  // namespace clipc::check
