// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "backend-glsl/writer/context.h"

// Inputs and their built-in variables, and where inputs and outputs lie.
namespace clipc::glsl {

// Lays the inputs and outputs at their locations.
void LayInterface(const WriterContext& context, GlslInfo& info);
// The declarations of the inputs that are laid so.
std::string WriteInputs(WriterContext& context, const GlslInfo& info);

// The text in place of an input: the attribute of this name, or a built-in variable of GLSL,
// converted to the input's type.
std::string InputText(const WriterContext& context, const ir::IoVar& input,
                      const std::string& attribute);
// The text of an input, of which the shader reads the vertices, at one of them.
std::string AtVertex(const WriterContext& context, ir::VarId input, std::string_view vertex);
// The name, "normals[1]", of an input or output at one vertex or control point: "normals[v][1]".
std::string AtVertex(std::string_view name, std::string_view vertex);
// Appends the declaration of an output, or of the matrix or array that it is a part of: "vec2 uv";
// "mat3 tangents", whose first column the output is. An input of a stage with a stage before is
// declared alike.
void AppendVarying(WriterContext& context, std::string& text, const ir::IoVar& io, Shape shape,
                   std::string_view name);

// Whether the variable is Direct3D's position of a pixel, gl_FragCoord with another w.
bool IsPixelPosition(const WriterContext& context, ir::VarId var);

}  // namespace clipc::glsl
