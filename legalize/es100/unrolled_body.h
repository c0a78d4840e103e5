// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "ir/program.h"
#include "legalize/es100/known_values.h"
#include "legalize/es100/long_loop.h"
#include "legalize/es100/refused.h"

namespace clipc::legalize {

// The limits of what is unrolled in a program, and the loops that are longer.
struct UnrollLimits {
  // fxc's X3511: "loop does not appear to terminate in a timely manner (1024 iterations)".
  static constexpr std::size_t kMostIterations = 1024;
  static constexpr std::size_t kMostExpressions = 1 << 16;

  std::uint32_t first_new = 0;  // the first expression that is made by unrolling
  std::vector<LongLoop> found = {};

  bool Allows(const ir::Program& program) const {
    return program.exprs.size() - first_new < kMostExpressions;
  }
};

// One function, walked in the order of execution: known values are folded, and refused loops are
// unrolled.
class UnrolledBody {
 public:
  // `known.now` has what is known where the body begins.
  UnrolledBody(ir::Program& program, Refused& refused, KnownValues& known, UnrollLimits& limits)
      : program_(program), refused_(refused), known_(known), limits_(limits) {}

  void Walk(ir::StmtId body);

 private:
  using Stmts = std::vector<ir::StmtId>;

  // A `break` or `continue` under a condition that is not known, and what is known there.
  struct Exit {
    ir::StmtId stmt;
    Values values;
  };
  // A loop that the walk is in.
  struct Loop {
    bool is_unrolled = false;
    std::size_t branches = 0;              // the unknown branches around it
    std::vector<ir::VarId> assigned = {};  // in a loop that is kept
    std::vector<Exit> breaks = {}, continues = {};
    bool breaks_for_sure = false, continues_for_sure = false;  // in this iteration
  };
  enum class Answer : std::uint8_t { kNo, kYes, kUnknown };

  // Walks a statement and appends what becomes of it. Returns whether the statement after it runs.
  bool Walk(ir::StmtId stmt, Stmts& out);
  bool WalkList(List<ir::StmtId> list, Stmts& out);
  bool WalkScope(ir::StmtId stmt, Stmts& out);
  bool WalkDeclare(ir::StmtId stmt, ir::Declare node, Stmts& out);
  bool WalkIf(ir::StmtId stmt, ir::If node, Stmts& out);
  bool WalkSwitch(ir::StmtId stmt, Stmts& out);
  bool WalkExit(ir::StmtId stmt, bool is_break, Stmts& out);
  bool WalkLoop(ir::StmtId stmt, Stmts& out);

  // ---- loops that are kept
  ir::StmtId WithFoldedHead(ir::StmtId stmt, const std::vector<bool>& assigned);
  bool MustUnroll(ir::StmtId folded, const std::vector<bool>& assigned) const;
  void Keep(ir::StmtId folded, const std::vector<bool>& assigned, Stmts& out);

  // ---- loops that are unrolled
  bool Unroll(ir::StmtId stmt, Stmts& out, bool& goes_on);
  bool UnrollInto(ir::StmtId stmt, Stmts& list, bool& goes_on);
  bool Iterate(ir::StmtId body, Stmts& list);
  Answer Test(ir::ExprId condition, Stmts& list);
  bool FitsLimits(ir::StmtId stmt, std::size_t iterations);
  void WrapIteration(Stmts& iteration, std::size_t first_break);
  ir::StmtId CopyOf(ir::StmtId stmt);

  // ---- where paths join
  void Join(Stmts* end, std::vector<Exit>& exits);
  void JoinBranches(const Values& other, Stmts& end, Stmts& other_end);
  void LeaveScope(std::size_t declared);
  bool IsVisible(ir::VarId var) const;
  void Append(const Stmts& inner, Stmts& out);

  ir::Program& program_;
  Refused& refused_;
  KnownValues& known_;
  UnrollLimits& limits_;
  std::vector<ir::VarId> declared_;  // the variables in scope
  std::vector<Loop> loops_;          // the outer ones first
  std::size_t branches_ = 0;         // the unknown branches around the statement
};

}  // namespace clipc::legalize
