// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/context.h"

// The types of the program in GLSL. Naming one writes the structs that it is made of.
namespace clipc::glsl {

// Arrays of this many elements and more are filled by a loop, shorter ones by a constructor.
inline constexpr std::uint32_t kLongArray = 17;

std::string TypeName(Context& context, ir::TypeId type);
std::string TypeName(Context& context, const Shape& shape);

// "float name[3]"
std::string Declaration(Context& context, ir::TypeId type, std::string_view name);
std::string Declaration(Context& context, const Shape& shape, std::string_view name);
// "uniform float name[3]": a uniform is an array wherever HLSL has one.
std::string UniformDeclaration(Context& context, ir::TypeId type, std::string_view name);
// "name[3]": what stands after the type in a declaration.
std::string Declarator(Context& context, ir::TypeId type, std::string_view name);
// "precise " for what is precise, where the target has the word.
std::string_view PreciseText(Context& context, bool is_precise);
// What tells overloads apart: "vec3, float".
std::string ParameterTypes(Context& context, ir::FunctionId function);
// "[4][2]" of an array of blocks or objects; empty when the variable is not an array.
std::string Dimensions(const Context& context, ir::VarId var);

// "vec3(0.0)"
std::string ZeroText(Context& context, ir::TypeId type);
std::string ZeroText(Context& context, const Shape& shape);

// Where arrays are not values, structs with the fields e0, e1 and so on stand for them: for arrays
// that are not uniforms, and for matrices in rows. Their indices are constant.
bool HasFields(const Context& context, const ir::Type& type);
// "m[1]" or "m.e1"
std::string RowOf(const Context& context, const Shape& matrix, std::string_view text, int row);

// Where GLSL has no arrays of arrays, the element of the outer one is a struct that has the inner
// one as its field `e`.
bool IsWrapped(const Context& context, ir::TypeId array_element);
// An element of an array as an argument of the array's constructor.
std::string ElementText(Context& context, ir::TypeId element, Text text);

// The body of a function that returns an array of element(index variable).
std::string FilledArray(Context& context, ir::TypeId array,
                        const std::function<std::string(const std::string&)>& element);

}  // namespace clipc::glsl
