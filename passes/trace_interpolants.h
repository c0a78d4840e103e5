// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// Names the input where a pixel shader evaluates it at another place, or at a vertex, by a
// parameter or a variable that has its value:
//
//   vec4 shader(Vertex v) { .. EvaluateAttributeAtSample(v.uv, 1) .. }
//     =>  vec4 shader(Vertex v) { .. EvaluateAttributeAtSample(in_TEXCOORD0, 1) .. }
//
// fxc and dxc, which inline functions, find the input so. Each call has to give a parameter the
// same input. What is written a second time, or has no one input, stays.
//
// Requires and ensures Form::kInlined.
void TraceInterpolants(ir::Program& program);

}  // namespace clipc::passes
