// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-glsl/target.h"
#include "ir/program.h"

namespace clipc::glsl {

// Declares as uniform variables the members of each constant buffer that the index of a loop
// indexes, in a fragment shader of a target that lacks Feature::kFreeIndices. Such a target has no
// blocks, and clipc's array of rows is read by functions, whose parameters are not the constants
// that the index of a uniform must be made of (GLSL ES 1.00, appendix A, 5).
//
//   uniform vec4 Globals[4];  colors_at(i)  =>  uniform vec4 colors[4];  colors[i]
void LoosenIndexedBlocks(ir::Program& program, const Target& target);

}  // namespace clipc::glsl
