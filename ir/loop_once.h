// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <vector>

#include "ir/program.h"

// Loops of one iteration, for what `break` and `continue` left in a loop that is unrolled.
namespace clipc::ir {

// Returns for (int once = 0; once < 1; once++) { body }, which a `break` or `continue` in the body
// leaves.
StmtId LoopOnce(Program& program, std::span<const StmtId> body);

// Returns an iteration of an unrolled loop in a loop of its own, which `continue` leaves. A `break`
// leaves it too, and the loop around it after it:
//
//   bool left = false;
//   for (int once = 0; once < 1; once++) { .. { left = true; break; } .. continue; .. }
//   if (left) break;
//
// `breaks` are those of the unrolled loop in the iteration. One that is not in a block becomes a
// block, and its id that of the new `break`.
std::vector<StmtId> IterationOnce(Program& program, std::span<const StmtId> iteration,
                                  std::span<StmtId> breaks);

}  // namespace clipc::ir
