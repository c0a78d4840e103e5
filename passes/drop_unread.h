// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// Removes local variables that nothing reads from `main`, and then those that only they read.
//
//   vec4 spare = vec4(in_NORMAL0, 1.0);        =>
//   gl_Position = in_POSITION0;                     gl_Position = in_POSITION0;
//
// A variable is kept when a branch or a loop gives it a value, or when computing a value of it
// changes something else.
//
// Requires and ensures Form::kInlined.
void DropUnread(ir::Program& program);

}  // namespace clipc::passes
