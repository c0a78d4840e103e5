// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Control flow of checked statements. A condition that is a constant is known, and so is the value
// of a switch; what control cannot reach then has no effect.
namespace clipc::check {

// How control can leave a statement.
struct Exits {
  bool falls = false;      // it reaches the end of the statement
  bool breaks = false;     // a `break` leaves the loop or switch around it
  bool continues = false;  // a `continue` leaves it
  bool returns = false;
};
Exits ExitsOf(const Program& program, StmtId id);
// Whether the condition of the loop is always true, and no `break` or `return` leaves it.
bool NeverEnds(const Context& context, StmtId loop);

}  // namespace clipc::check
