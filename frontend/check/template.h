// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <span>

#include "frontend/check/context.h"

// HLSL 2021 templates. An instance is a scope in which the parameters have names, and a copy of the
// declaration that is looked up there. Arguments are kept as numbers: a type's id, or the 32 bits
// of a value.
namespace clipc::check {

// S<float>; nothing when `id` is no template.
std::optional<ir::TypeId> InstantiateStruct(Context& context, SymbolId id, const ast::Type& type);
// The instance of a function template that a call asks for; none when the arguments do not say
// enough.
FunctionInfoId InstantiateFunction(Context& context, SymbolId id, ir::TypeId self,
                                   List<ast::ExprId> explicit_arguments,
                                   std::span<const ir::ExprId> arguments);

}  // namespace clipc::check
