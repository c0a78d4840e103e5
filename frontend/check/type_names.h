// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string_view>

#include "frontend/check/context.h"

// The built-in types of HLSL in all their spellings.
namespace clipc::check {

// void, string, float, float3, float3x4, for every scalar type.
std::optional<TypeId> NumericType(Context& context, Name name);
// A template argument as a type. Names are expressions in the syntax tree.
TypeId TypeArgument(Context& context, ast::ExprId id);
// vector, vector<float, 3>, matrix, matrix<float, 3, 4>
std::optional<TypeId> GenericNumericType(Context& context, const ast::Type& type,
                                         std::string_view text);
// Textures, samplers, buffers; ConstantBuffer<T> inside a function is T.
std::optional<TypeId> ObjectType(Context& context, const ast::Type& type, std::string_view text);

}  // namespace clipc::check
