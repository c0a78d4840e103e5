// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// Makes `main` the shader that a person would have written: the body of the entry point replaces
// its call, and structs that only carry inputs and outputs become those inputs and outputs
// (split_variables.h).
//
//   Vertex v; v.position = in_POSITION0;
//   Varyings result = shader(v);
//   gl_Position = result.position; vs_COLOR0 = result.color;
//       =>
//   gl_Position = view * float4(in_POSITION0, 1);
//   vs_COLOR0 = tint;
//
//   =>  gl_Position = view * float4(in_POSITION0, 1);
//       vs_COLOR0 = tint;
//
// An entry point that returns early keeps its function, and a struct that is used as a whole stays
// a struct. The outputs keep their values, bit for bit.
//
// Requires Form::kTargetClipSpace. Ensures Form::kInlined.
void InlineEntry(ir::Program& program);

}  // namespace clipc::passes
