// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "backend-glsl/writer/context.h"

// Inputs, outputs and built-in variables.
namespace clipc::glsl {

// Lays the inputs and outputs at their locations.
void LayInterface(const WriterContext& context, GlslInfo& info);
// The declarations of what is laid so.
std::string WriteInputs(WriterContext& context, const GlslInfo& info);
std::string WriteOutputs(WriterContext& context, const GlslInfo& info);

// The text in place of an input: the attribute of this name, or a built-in variable of GLSL,
// converted to the input's type.
std::string InputText(const WriterContext& context, const ir::IoVar& input,
                      const std::string& attribute);
// The text of an input, of which the shader reads the vertices, at one of them.
std::string AtVertex(const WriterContext& context, ir::VarId input, std::string_view vertex);
// The built-in variable of the target's GLSL that an output is.
std::string_view BuiltinOutput(ir::Builtin builtin, const Target& target);

// Whether the variable is Direct3D's position of a pixel, gl_FragCoord with another w.
bool IsPixelPosition(const WriterContext& context, ir::VarId var);

// Whether GLSL has the output as an int, which is a uint in HLSL.
bool IsIntOutput(ir::Builtin builtin);

}  // namespace clipc::glsl
