// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "ir/program.h"

namespace clipc::ir {

// The parts of a loop that counts. A part that the loop lacks, or has in another form, is an
// invalid id.
//
//   for (int i = start; i < limit && more; i += step)
struct CountedLoop {
  VarId counter;
  bool is_declared = false;  // whether the head declares the counter; otherwise it assigns to it
  ExprId start = {};
  ExprId comparison = {};  // `i < limit`, with the counter, or a conversion of it, on the left
  ExprId more = {};        // the other side of the `&&` that the comparison is in
  ExprId step = {};        // `++i`, `i--`, `i += n` or `i -= n`
  ExprId step_size = {};   // the `n`; invalid for `++i` and `i--`
  bool is_down = false;
};

// The parts of the loop. Its counter is the variable that the condition compares. Where the head
// gives values to variables of which the condition compares none, the counter is the first of them;
// where the head does something else too, there is no counter.
CountedLoop PartsOf(const Program& program, const For& loop);

// Whether the body changes the variable.
bool IsChangedInBody(const Program& program, const For& loop, VarId counter);

// The `break` statements in the body that end the loop, and the `continue` statements that end an
// iteration of it.
struct LoopJumps {
  std::vector<StmtId> breaks = {}, continues = {};
};
LoopJumps JumpsOf(const Program& program, StmtId body);

}  // namespace clipc::ir
