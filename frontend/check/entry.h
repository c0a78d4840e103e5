// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Finding the entry point.
namespace clipc::check {

// The one function that the options name. The name is looked up from global scope; a name without
// `::` that global scope does not have is also found when exactly one namespace has it. Prototypes
// do not count. None after an error, which was reported.
FunctionInfoId FindEntry(Context& context);

}  // namespace clipc::check
