// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/context.h"

// The built-in types of HLSL in all their spellings.
namespace clipc::check {

// The type that is named void, string, float, float3 or float3x4, with any scalar type for float;
// nullopt for other names.
std::optional<TypeId> NumericType(Context& context, Name name);
// The built-in types that are spelt nearly like the text: float4 for flaot4, Texture2D for
// Texure2D.
std::vector<std::string> NearTypes(std::string_view text);
// The type that a template argument is. Names are expressions in the syntax tree.
TypeId TypeArgument(Context& context, ast::ExprId id);
// The type that is written vector, vector<float, 3>, matrix or matrix<float, 3, 4>; nullopt for
// other types.
std::optional<TypeId> GenericNumericType(Context& context, const ast::Type& type,
                                         std::string_view text);
// The type of a texture, sampler or buffer; ConstantBuffer<T> inside a function is T. Returns
// nullopt for other types.
std::optional<TypeId> ObjectType(Context& context, const ast::Type& type, std::string_view text);
// Whether the name is that of an object that shaders write, RWBuffer and the like.
bool IsWritableObjectName(std::string_view text);
// Whether CheckTypeArgument may report something: a quick look at the text of the type.
bool MayMisfit(const Context& context, const ast::Type& type);
// Whether the type argument is one that the texture or buffer may have, or the type is something
// else; reports it otherwise. An argument that no object has is an error of a declaration that
// nothing uses, too.
bool CheckTypeArgument(Context& context, const ast::Type& type);
// Whether the name is that of a patch of control points, which is a constant array in the stages
// that clipc compiles (vkd3d's patch-syntax.shader_test, checked against native).
bool IsPatchName(std::string_view text);

}  // namespace clipc::check
