// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// Reads the bound of a loop before the loop if the bound is made of uniforms and literals alone,
// since drivers would read it again in each iteration.
//
//   while (i < lights) ..   =>   int lights_1 = lights; while (i < lights_1) ..
//
// Requires and ensures Form::kInlined.
void HoistLoopBounds(ir::Program& program);

}  // namespace clipc::passes
