// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "ir/program.h"

namespace clipc::resolve {

// What ends an iteration on every path of it.
enum class LoopJump : std::uint8_t { kNone, kContinue, kBreak };

// Removes the first `break` or `continue` that an iteration of a loop always comes to, and what is
// after it. `body` is the iteration's own copy of the loop's body.
LoopJump CutAtJump(ir::Program& program, ir::StmtId body);

// The statements that a loop becomes when it is unrolled:
//
//   for (int i = 0; i < 2; ++i) { if (c[i]) continue; f(i); if (d[i]) break; }
//     =>  for (int once = 0; once < 1; once++) {  // `break` leaves it
//           an iteration, as IterationOnce has it, for each value of `i`
//         }
//
// A loop without `break` needs no loop around its iterations, and an iteration without `continue`
// none of its own.
class UnrolledLoop {
 public:
  explicit UnrolledLoop(ir::Program& program) : program_(program) {}

  // Adds a statement between iterations.
  void Add(ir::StmtId stmt) { stmts_.push_back(stmt); }
  // Adds an iteration, which CutAtJump has cut. Returns whether another one may come after it.
  bool AddIteration(ir::StmtId body, LoopJump end);
  // What takes the place of the loop.
  decltype(ir::Stmt::node) Finish();

 private:
  ir::Program& program_;
  std::vector<ir::StmtId> stmts_;
  bool has_break_ = false;
};

}  // namespace clipc::resolve
