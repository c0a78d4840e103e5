// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"
// Control flow of checked statements.
namespace clipc::check {

// Whether control can reach the end of the statement.
bool FallsThrough(const Context& context, StmtId id);
// Whether the condition of the loop is always true, and no `break` or `return` leaves it.
bool NeverEnds(const Context& context, StmtId loop);

}  // namespace clipc::check
