// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"
#include "passes/inline_entry.h"

namespace clipc::passes {

// Scalar replacement of the structs that only carry inputs or outputs: each field becomes the input
// that it is loaded from, the output that it is stored to, or a local variable. A variable of
// another type is replaced in the same way. `parts` is what InlineEntry returned.
//
//   Vertex v; v.position = in_POSITION0;           =>
//   Varyings o;
//   o.position = v.position * 2.0;                      gl_Position = in_POSITION0 * 2.0;
//   gl_Position = o.position;
//
// A struct that something uses as a whole is kept, and gets its inputs in one statement:
//
//   Vertex v; v.position = in_POSITION0; v.uv = in_UV0;
//       =>
//   Vertex v = Vertex(in_POSITION0, in_UV0);
//
// The outputs keep their values, bit for bit. Requires and ensures Form::kInlined.
void SplitVariables(ir::Program& program, const MainParts& parts);

}  // namespace clipc::passes
