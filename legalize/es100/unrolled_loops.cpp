// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <span>
#include <utility>
#include <variant>

#include "ir/access.h"
#include "ir/builder.h"
#include "ir/counted_loop.h"
#include "ir/evaluate.h"
#include "ir/loop_once.h"
#include "ir/walk.h"
#include "legalize/es100/loops.h"
#include "legalize/es100/unrolled_body.h"

// The loops of UnrolledBody.
namespace clipc::legalize {

using namespace ir;

namespace {

// The number of conditions that `&&` joins.
std::size_t CountConditions(const Program& program, ExprId expr) {
  const auto* both = As<Binary>(program, expr);
  const bool is_and =
      both && (both->op == BinaryOp::kLogicalAnd || both->op == BinaryOp::kShortCircuitAnd);
  return is_and ? CountConditions(program, both->left) + CountConditions(program, both->right) : 1;
}

ExprId ConditionOf(const Program& program, StmtId loop) {
  if (const auto* node = As<For>(program, loop)) return node->condition;
  if (const auto* node = As<While>(program, loop)) return node->condition;
  return As<DoWhile>(program, loop)->condition;
}
StmtId BodyOfLoop(const Program& program, StmtId loop) {
  if (const auto* node = As<For>(program, loop)) return node->body;
  if (const auto* node = As<While>(program, loop)) return node->body;
  return As<DoWhile>(program, loop)->body;
}

}  // namespace

bool UnrolledBody::WalkLoop(StmtId stmt, Stmts& out) {
  const std::vector<bool> assigned = AssignedIn(program_, std::span(&stmt, 1));
  const StmtId folded = WithFoldedHead(stmt, assigned);
  bool goes_on = true;
  if (MustUnroll(folded, assigned) && Unroll(stmt, out, goes_on)) return goes_on;
  Keep(folded, assigned, out);
  return true;
}

// ---- loops that are kept

// The loop with what is known before it in its head, except the variables that it changes. It has
// the same body.
StmtId UnrolledBody::WithFoldedHead(StmtId stmt, const std::vector<bool>& assigned) {
  Stmt loop = program_.stmts[stmt];
  const Values before = known_.now;
  std::erase_if(known_.now, [&](const auto& each) { return assigned[each.first.index]; });
  const auto fold = [&](ExprId& expr) {
    if (!expr) return;
    expr = Clone(program_, expr);
    known_.FoldUnknown(expr);
  };
  if (auto* node = std::get_if<For>(&loop.node)) {
    Stmts init;
    for (std::uint32_t i = 0; i < node->init.size; ++i) {
      Stmt part = program_.stmts[program_.stmt_lists[node->init][i]];
      if (auto* declare = std::get_if<Declare>(&part.node)) fold(declare->init);
      if (auto* evaluate = std::get_if<Evaluate>(&part.node)) fold(evaluate->expr);
      init.push_back(program_.stmts.Add(std::move(part)));
    }
    node->init = program_.stmt_lists.Add(init);
    fold(node->condition);
    fold(node->step);
  } else if (auto* node = std::get_if<While>(&loop.node)) {
    fold(node->condition);
  } else {
    fold(std::get<DoWhile>(loop.node).condition);
  }
  known_.now = before;
  return program_.stmts.Add(std::move(loop));
}

// Whether appendix A lacks the loop, or an index in it depends on what it changes.
bool UnrolledBody::MustUnroll(StmtId folded, const std::vector<bool>& assigned) const {
  CountedLoop loop;
  if (!WhyNotAlone(program_, folded, loop).empty()) return true;
  const bool is_local = program_.vars[loop.counter].storage == Storage::kLocal;
  if (!loop.is_declared && (!is_local || refused_.IsUsedOutside(loop.counter))) return true;
  bool changes_source = false;
  for (std::uint32_t i = 0; i < assigned.size(); ++i)
    changes_source |= assigned[i] && refused_.IsSource(VarId{i});
  return changes_source && AnyExpr(program_, BodyOfLoop(program_, folded),
                                   [&](ExprId expr) { return refused_.IsRefusedIndex(expr); });
}

void UnrolledBody::Keep(StmtId folded, const std::vector<bool>& assigned, Stmts& out) {
  Loop loop;
  for (const VarId var : declared_) {
    if (assigned[var.index]) loop.assigned.push_back(var);
  }
  for (const auto& [var, value] : Values(known_.now)) {
    if (!assigned[var.index]) continue;
    if (program_.vars[var].storage == Storage::kIn) loop.assigned.push_back(var);
    known_.Store(var, out);
    known_.Forget(var);
  }
  const std::vector<VarId> stored = loop.assigned;
  const Values before = known_.now;
  const std::size_t declared = declared_.size();
  if (const auto* node = As<For>(program_, folded)) {
    for (const StmtId part : program_.stmt_lists[node->init])
      if (const auto* declare = As<Declare>(program_, part)) declared_.push_back(declare->var);
  }
  loops_.push_back(std::move(loop));
  Stmts list;
  if (WalkScope(BodyOfLoop(program_, folded), list)) {
    for (const VarId var : stored) known_.Store(var, list);
  }
  loops_.pop_back();
  LeaveScope(declared);
  known_.now = before;
  const StmtId body = Builder(program_, program_.stmts[folded].span).BlockOf(list);
  std::visit(
      [&](auto& node) {
        if constexpr (requires { node.condition, node.body; }) node.body = body;
      },
      program_.stmts[folded].node);
  out.push_back(folded);
}

// ---- loops that are unrolled

StmtId UnrolledBody::CopyOf(StmtId stmt) {
  BodyCloner cloner(program_);
  const StmtId copy = cloner.Clone(stmt);
  refused_.AddCopies(cloner);
  return copy;
}

// Returns false, and appends nothing, if the iterations are not known or too many.
bool UnrolledBody::Unroll(StmtId stmt, Stmts& out, bool& goes_on) {
  const Values before = known_.now;
  const std::size_t declared = declared_.size();
  loops_.push_back({.is_unrolled = true, .branches = branches_});
  Stmts list;
  const bool is_unrolled = UnrollInto(CopyOf(stmt), list, goes_on);
  std::vector<Exit> breaks = std::move(loops_.back().breaks);
  loops_.pop_back();
  LeaveScope(declared);
  if (!is_unrolled) {
    known_.now = before;
    return false;
  }
  if (breaks.empty()) {
    Append(list, out);
    return true;
  }
  Join(goes_on ? &list : nullptr, breaks);
  out.push_back(LoopOnce(program_, list));
  goes_on = true;
  return true;
}

bool UnrolledBody::UnrollInto(StmtId stmt, Stmts& list, bool& goes_on) {
  const std::size_t number = loops_.size() - 1;
  const auto* head = As<For>(program_, stmt);
  const ExprId step_of_all = head ? head->step : ExprId{};
  if (head) WalkList(head->init, list);
  const ExprId condition = ConditionOf(program_, stmt);
  const bool is_do = As<DoWhile>(program_, stmt) != nullptr;
  for (std::size_t iterations = 0;; ++iterations) {
    if (condition && !(is_do && iterations == 0)) {
      const Answer answer = Test(condition, list);
      if (answer != Answer::kYes) return answer == Answer::kNo;
    }
    if (!FitsLimits(stmt, iterations)) return false;
    goes_on = Iterate(BodyOfLoop(program_, stmt), list);
    if (std::exchange(loops_[number].breaks_for_sure, false))
      goes_on = true;
    else if (goes_on && step_of_all) {
      const ExprId step = Clone(program_, step_of_all);
      known_.Fold(step, list);
      if (!IsPure(program_, step)) list.push_back(Builder(program_).Eval(step));
      continue;
    } else if (goes_on) {
      continue;
    }
    return true;
  }
}

// Appends one more iteration. Returns whether there may be a further one.
bool UnrolledBody::Iterate(StmtId body, Stmts& list) {
  const std::size_t number = loops_.size() - 1;
  loops_[number].continues_for_sure = false;
  const std::size_t first_break = loops_[number].breaks.size();
  Stmts iteration;
  bool goes_on = WalkScope(CopyOf(body), iteration);
  Loop& loop = loops_[number];
  goes_on |= loop.continues_for_sure;
  std::vector<Exit> continues = std::move(loop.continues);
  loop.continues.clear();
  if (!continues.empty()) {
    // The path to the end is one of several: a break there leaves the others.
    if (std::exchange(loop.breaks_for_sure, false)) {
      iteration.push_back(Builder(program_).Stmt(Break{}));
      loop.breaks.push_back({iteration.back(), known_.now});
    }
    Join(goes_on ? &iteration : nullptr, continues);
    WrapIteration(iteration, first_break);
    goes_on = true;
  }
  Append(iteration, list);
  return goes_on;
}

// Asks the condition of the next iteration. One that is known but for others beside it, joined by
// `&&`, becomes a break.
UnrolledBody::Answer UnrolledBody::Test(ExprId condition, Stmts& list) {
  const ExprId test = Clone(program_, condition);
  known_.Fold(test, list);
  if (const auto bits = ConstantBits(program_, test))
    return bits->front() != 0 ? Answer::kYes : Answer::kNo;
  if (CountConditions(program_, test) >= CountConditions(program_, condition))
    return Answer::kUnknown;
  Builder b(program_, program_.exprs[condition].span);
  const StmtId stop = b.Stmt(Break{});
  loops_.back().breaks.push_back({stop, known_.now});
  list.push_back(b.Stmt(If{b.UnaryOf(UnaryOp::kNot, test), b.BlockOf(std::span(&stop, 1)), {}}));
  return Answer::kYes;
}

// A loop that has no condition, or a constant as that, is not known to end.
bool UnrolledBody::FitsLimits(StmtId stmt, std::size_t iterations) {
  const ExprId condition = ConditionOf(program_, stmt);
  const bool ends = condition && AnyExpr(program_, condition, [&](ExprId part) {
                      return As<VarRef>(program_, part) != nullptr;
                    });
  const bool is_too_often = iterations >= UnrollLimits::kMostIterations;
  if (!is_too_often && limits_.Allows(program_)) return true;
  if (ends && is_too_often)
    limits_.found.push_back(
        {program_.stmts[stmt].span, UnrollLimits::kMostIterations, "iterations"});
  else if (ends)
    limits_.found.push_back(
        {program_.stmts[stmt].span, UnrollLimits::kMostExpressions, "expressions"});
  return false;
}

// Puts an iteration into a loop of its own. The path to its end is not the only one.
void UnrolledBody::WrapIteration(Stmts& iteration, std::size_t first_break) {
  const std::span<Exit> exits = std::span(loops_.back().breaks).subspan(first_break);
  Stmts breaks;
  for (const Exit& exit : exits) breaks.push_back(exit.stmt);
  iteration = IterationOnce(program_, iteration, breaks);
  for (std::size_t i = 0; i < exits.size(); ++i) exits[i].stmt = breaks[i];
}

}  // namespace clipc::legalize
