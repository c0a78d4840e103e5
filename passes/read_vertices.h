// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// V v[3]; v[0].uv = <uv of vertex 0>; ..; use(v[i].uv)    =>    use(<uv of vertex i>)
//
// Reads the inputs of a vertex where `main` reads an element of an array of vertices, if it writes
// no element and reads none as a whole. Then the array is not needed, and an input that nothing
// reads is not one.
//
// Requires and ensures Form::kInlined.
void ReadVertices(ir::Program& program);

}  // namespace clipc::passes
