// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string_view>

#include "frontend/check/context.h"

// The types that HLSL has built in, in all their spellings.
namespace clipc::check {

// void, float, float3, float3x4, for every scalar type.
std::optional<ir::TypeId> NumericType(Context& context, Name name);
// A type as a template argument. Names arrive as expressions.
ir::TypeId TypeArgument(Context& context, ast::ExprId id);
// vector, vector<float, 3>, matrix, matrix<float, 3, 4>
std::optional<ir::TypeId> GenericNumericType(Context& context, const ast::Type& type,
                                             std::string_view text);
std::optional<ir::TypeId> ObjectType(Context& context, const ast::Type& type,
                                     std::string_view text);

}  // namespace clipc::check
