// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "backend-glsl/target.h"
#include "ir/program.h"

namespace clipc::glsl {

// A loop that is too long to be unrolled, and the limit.
struct LongLoop {
  Span span;
  std::size_t limit;
  std::string_view of;
};

// Makes constants of known values where a target that lacks Feature::kFreeLoops needs constants: in
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
std::vector<LongLoop> UnrollLoops(ir::Program& program, const Target& target);

}  // namespace clipc::glsl
