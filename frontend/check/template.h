// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "frontend/check/context.h"

// Templates of HLSL 2021. An instance is a scope in which the parameters have names, and a copy of
// the declaration that is looked up there. Arguments are kept as numbers: a type's id, or the 32
// bits of a value.
namespace clipc::check {

// The type S<float>; nullopt if the symbol is not a template.
std::optional<TypeId> InstantiateStruct(Context& context, SymbolId id, const ast::Type& type);
// The type that A<float> names, of `template<typename T> using A = ..;`; nullopt if the symbol is
// not such a template.
std::optional<TypeId> InstantiateAlias(Context& context, SymbolId id, const ast::Type& type);
// The instance of a function template that a call asks for; none if the arguments of the call do
// not determine those of the template.
FunctionInfoId InstantiateFunction(Context& context, SymbolId id, TypeId self,
                                   List<ast::ExprId> explicit_arguments, ExprSpan arguments);

}  // namespace clipc::check
