// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "ir/program.h"
#include "legalize/es100/long_loop.h"
#include "legalize/needs.h"

namespace clipc::legalize {

// Makes constants of known values where a target with Needs::constant_loops needs constants: in
// the heads of loops and in the indices of uniforms of a pixel shader. A loop that appendix A of
// GLSL ES 1.00 does not have, or whose counter an index is computed from, is unrolled, and a
// function with such a loop or index is copied for the constants of its calls. fxc inlines, folds
// and unrolls alike for the profiles without loops.
//
//   float4 f(float4 p, int n) { for (int i = 0; i < n; ++i) p += k[i]; return p; }  ..  f(p, 3)
//     =>  float4 f(float4 p) { for (int i = 0; i < 3; ++i) p += k[i]; return p; }  ..  f(p)
//   int i = 2; while (i-- > 0) p += k[i];
//     =>  p += k[1]; p += k[0];
//
// Functions without such loops and indices stay as they are. Returns the loops with known
// iterations that are too long; they stay too, and CheckTarget refuses them. Requires and ensures
// Form::kInlined.
std::vector<LongLoop> UnrollLoops(ir::Program& program, const Needs& needs);

}  // namespace clipc::legalize
