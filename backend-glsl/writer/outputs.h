// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "backend-glsl/writer/context.h"

// What the shader gives: varyings, render targets, built-in variables, patch constants.
namespace clipc::glsl {

// The declarations of the outputs that `info` lays.
std::string WriteOutputs(WriterContext& context, const GlslInfo& info);

// The built-in variable of the target's GLSL that an output is.
std::string_view BuiltinOutput(ir::Builtin builtin, const Target& target);

// Whether GLSL has the output as an int, which is a uint in HLSL.
bool IsIntOutput(ir::Builtin builtin);

// The elements of an output array that the shader assigns, one bit for each; all if it assigns the
// whole array or an element whose index is not constant. The array is only the target of
// statements, a promise of ir/verify.h.
std::uint32_t WrittenElements(const WriterContext& context, ir::VarId array);

// Gives the outputs of a stage that makes patches their names at the control point that the shader
// runs for: "normal[gl_InvocationID]". `info` lays them; it has the names of the arrays.
void NameAtPoint(WriterContext& context, const GlslInfo& info);
// The text of an output of such a stage at a control point.
std::string AtPoint(const WriterContext& context, ir::VarId output, std::string_view point);

}  // namespace clipc::glsl
