// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"
// Function bodies: the queue of those that are reached, and their check.
namespace clipc::check {

// The function of the program. Its body waits to be checked after the first call.
FunctionId Reach(Context& context, FunctionInfoId id);
// Checks the bodies that wait, and those that they reach in turn.
void CheckBodies(Context& context);
// Reports functions that call themselves, directly or through others.
void CheckRecursion(Context& context);

}  // namespace clipc::check
