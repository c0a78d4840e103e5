// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// Spreads `precise` to the functions that compute a precise value. fxc inlines every call, so that
// all of it is computed as written; GLSL looks into no call, so what the function returns becomes a
// precise variable, and its `out` parameters become precise.
//
//   float4 f(float4 p) {            =>   vec4 f(vec4 p) {
//     return p * 2 + 1;                      precise vec4 result = p * 2.0 + 1.0;
//   }                                        return result;
//   precise float4 a = f(b);             }
//                                        precise vec4 a = f(b);
//
// A variable of a struct with a precise field becomes precise as a whole. `of_all_outputs` is -Gis:
// every output is precise, and so is what goes into it.
//
// Requires and ensures Form::kInlined.
void SpreadPrecise(ir::Program& program, bool of_all_outputs);

}  // namespace clipc::passes
