// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"
// Function bodies: the queue of the bodies that are reached, and their check.
namespace clipc::check {

// The function of the program that `id` is. The first call adds its body to the bodies that wait to
// be checked.
FunctionId Reach(Context& context, FunctionInfoId id);
// Checks the bodies that wait, and the bodies that they reach in turn.
void CheckBodies(Context& context);
// Reports functions that call themselves, directly or through others.
void CheckRecursion(Context& context);

}  // namespace clipc::check
