// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/names.h"

namespace clipc::rules {

// Checks what the threads of a group do together, in a stage that runs in groups: the memory that
// they share has the size that the profile has at most, and they wait for each other in flow that
// all of them come to. There fxc reports X3663; dxc waits for threads that do not come, which GLSL
// leaves undefined too: a warning from 6.0 on. Requires a program without errors; needs time linear
// in it.
void CheckGroups(const Program& program, Diagnostics& diagnostics);

}  // namespace clipc::rules
