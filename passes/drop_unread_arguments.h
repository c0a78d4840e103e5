// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// Passes zeros, instead of inputs, to an entry function that is still called and does not read
// them. The inputs are then no longer read.
//
//   Vertex v = Vertex(in_POSITION0, in_NORMAL0);   =>   Vertex v = Vertex(in_POSITION0, vec3(0.0));
//   shader(v, in_TEXCOORD0);                            shader(v, vec2(0.0));
//
// An input that no target has is not read either where a struct carries it through further calls.
// A struct that the function reads as a whole keeps all of its fields. An argument that changes
// something is kept too.
//
// Requires and ensures Form::kInlined.
void DropUnreadArguments(ir::Program& program);

}  // namespace clipc::passes
