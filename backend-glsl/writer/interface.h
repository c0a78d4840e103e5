// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-glsl/writer/context.h"

// Inputs, outputs and built-in variables.
namespace clipc::glsl {

void WriteInputs(Context& context);
void WriteOutputs(Context& context);

// Whether GLSL has the output as an int, which is a uint in HLSL.
bool IsIntOutput(ir::Builtin builtin);

}  // namespace clipc::glsl
