// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

namespace clipc::check {

// The function in the program; its body waits to be checked.
ir::FunctionId Reach(Context& context, FunctionInfoId id);
void CheckBodies(Context& context);
// Functions may not call themselves, through others either.
void CheckRecursion(Context& context);

}  // namespace clipc::check
