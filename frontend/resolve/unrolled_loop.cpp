// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/unrolled_loop.h"

#include <algorithm>

#include "ir/access.h"
#include "ir/builder.h"
#include "ir/counted_loop.h"
#include "ir/loop_once.h"

namespace clipc::resolve {

using namespace ir;

namespace {

// Appends a statement, or those of a block, which stay a block if they declare a variable.
void Append(Program& program, StmtId stmt, std::vector<StmtId>& stmts) {
  const auto* block = As<Block>(program, stmt);
  if (!block) return stmts.push_back(stmt);
  std::vector<StmtId> inner;
  const List<StmtId> list = block->body;
  for (std::uint32_t i = 0; i < list.size; ++i) Append(program, program.stmt_lists[list][i], inner);
  const bool is_scope = std::ranges::any_of(
      inner, [&](StmtId part) { return As<Declare>(program, part) != nullptr; });
  if (is_scope) inner = {Builder(program, program.stmts[stmt].span).BlockOf(inner)};
  stmts.insert(stmts.end(), inner.begin(), inner.end());
}

}  // namespace

LoopJump CutAtJump(Program& program, StmtId body) {
  const bool is_break = As<Break>(program, body) != nullptr;
  if (is_break || As<Continue>(program, body)) {
    program.stmts[body].node = Block{};
    return is_break ? LoopJump::kBreak : LoopJump::kContinue;
  }
  const auto* block = As<Block>(program, body);
  if (!block) return LoopJump::kNone;
  const List<StmtId> list = block->body;
  for (std::uint32_t i = 0; i < list.size; ++i) {
    const LoopJump jump = CutAtJump(program, program.stmt_lists[list][i]);
    if (jump == LoopJump::kNone) continue;
    program.stmts[body].node = Block{{list.begin, i + 1}};
    return jump;
  }
  return LoopJump::kNone;
}

bool UnrolledLoop::AddIteration(StmtId body, LoopJump end) {
  std::vector<StmtId> iteration;
  LoopJumps jumps = JumpsOf(program_, body);
  Append(program_, body, iteration);
  const bool goes_on = end != LoopJump::kBreak || !jumps.continues.empty();
  if (end == LoopJump::kBreak && goes_on) {
    iteration.push_back(Builder(program_, program_.stmts[body].span).Stmt(Break{}));
    jumps.breaks.push_back(iteration.back());
  }
  if (!jumps.continues.empty()) iteration = IterationOnce(program_, iteration, jumps.breaks);
  has_break_ = has_break_ || !jumps.breaks.empty();
  stmts_.insert(stmts_.end(), iteration.begin(), iteration.end());
  return goes_on;
}

decltype(Stmt::node) UnrolledLoop::Finish() {
  if (has_break_) return program_.stmts[LoopOnce(program_, stmts_)].node;
  return Block{program_.stmt_lists.Add(stmts_)};
}

}  // namespace clipc::resolve
