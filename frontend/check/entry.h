// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// The entry point: finding it, its signature, its clip planes.
namespace clipc::check {

// The one function that the options name: as written from global scope; a simple name that global
// scope lacks, too, when one namespace alone has it. Prototypes do not count. None after an error.
FunctionInfoId FindEntry(Context& context);

}  // namespace clipc::check
