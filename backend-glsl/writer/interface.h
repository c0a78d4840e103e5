// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "backend-glsl/writer/context.h"

// Inputs, outputs and built-in variables.
namespace clipc::glsl {

struct Inputs {
  std::string text;                      // the declarations
  std::vector<GlslInfo::Variable> info;  // beside Program::inputs
};
Inputs WriteInputs(WriterContext& context);

struct Outputs {
  std::string text;                      // the declarations
  std::vector<GlslInfo::Variable> info;  // beside Program::outputs
  std::uint32_t clip_distance_mask = 0, cull_distance_mask = 0;
};
Outputs WriteOutputs(WriterContext& context);

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
