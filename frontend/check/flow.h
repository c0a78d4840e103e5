// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"
// Control flow of checked statements.
namespace clipc::check {

// Whether control can reach the end of the statement.
bool FallsThrough(const Context& context, StmtId id);

}  // namespace clipc::check
