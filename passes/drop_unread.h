// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// Takes local variables that nothing reads out of `main`, and what only they read.
//
//   vec4 spare = vec4(in_NORMAL0, 1.0);        =>
//   gl_Position = in_POSITION0;                     gl_Position = in_POSITION0;
//
// A variable that is given a value inside a branch or a loop, or a value that does something else
// too, stays. An entry function that is still called, as it returns early, gets zeros for the
// inputs that it does not read.
//
// Requires and ensures Form::kInlined.
void DropUnread(ir::Program& program);

}  // namespace clipc::passes
