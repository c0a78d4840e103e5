// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/context.h"

// The types of the program in GLSL. Naming one writes the structs that it is made of.
namespace clipc::glsl {

// Zeros of arrays of this many elements and more are filled by a loop, shorter ones by a
// constructor.
inline constexpr std::uint32_t kLongArray = 17;

std::string TypeName(WriterContext& context, ir::TypeId type);
std::string TypeName(WriterContext& context, const Shape& shape);

// The declaration "float name[3]".
std::string Declaration(WriterContext& context, ir::TypeId type, std::string_view name);
std::string Declaration(WriterContext& context, const Shape& shape, std::string_view name);
void AppendDeclaration(WriterContext& context, std::string& text, ir::TypeId type,
                       std::string_view name);
void AppendDeclaration(WriterContext& context, std::string& text, const Shape& shape,
                       std::string_view name);
// The declaration "float name[3]" of a uniform, which is an array wherever HLSL has one.
std::string UniformDeclaration(WriterContext& context, ir::TypeId type, std::string_view name);
// The part "name[3]" of a declaration, after the type.
std::string Declarator(WriterContext& context, ir::TypeId type, std::string_view name);
// The qualifier "precise " if `is_precise` and the target has the word; otherwise empty.
std::string_view PreciseText(WriterContext& context, bool is_precise);
// The qualifier "mediump " if values of the type, or of the input or output, may have 16 bits;
// otherwise empty.
std::string_view PrecisionText(const WriterContext& context, ir::TypeId type);
std::string_view PrecisionText(const WriterContext& context, const ir::IoVar& io);
// The types of the parameters, which tell overloads apart: "vec3, float".
std::string ParameterTypes(WriterContext& context, ir::FunctionId function);
// The dimensions "[4][2]" of an array of blocks or objects; empty if the variable is not an array.
std::string Dimensions(const WriterContext& context, ir::VarId var);

// The zero of a type: "vec3(0.0)".
std::string ZeroText(WriterContext& context, ir::TypeId type);
std::string ZeroText(WriterContext& context, const Shape& shape);

// Whether a struct with the fields e0, e1 and so on takes the place of the type, as it does where
// arrays are not values: for arrays that are not uniforms, and for matrices in rows. The indices of
// such a type are constant.
bool HasFields(const WriterContext& context, const ir::Type& type);
// The row "m[1]" or "m.e1" of a matrix.
std::string RowOf(const WriterContext& context, const Shape& matrix, std::string_view text,
                  int row);

// Whether the element of an array is a struct that has an inner array as its field `e`, as it is
// where GLSL has no arrays of arrays.
bool IsWrapped(const WriterContext& context, ir::TypeId array_element);
// An element of an array as an argument of the array's constructor.
std::string ElementText(WriterContext& context, ir::TypeId element, Text text);

}  // namespace clipc::glsl
