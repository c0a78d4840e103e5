// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/es100/unrolled_body.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "ir/access.h"
#include "ir/builder.h"
#include "ir/evaluate.h"
#include "ir/walk.h"

namespace clipc::legalize {

using namespace ir;

void UnrolledBody::Walk(StmtId body) {
  Stmts list;
  WalkScope(body, list);
  program_.stmts[body].node = Block{program_.stmt_lists.Add(list)};
}

// ---- statements

bool UnrolledBody::WalkList(List<StmtId> list, Stmts& out) {
  for (std::uint32_t i = 0; i < list.size; ++i) {
    if (!Walk(program_.stmt_lists[list][i], out)) return false;
  }
  return true;
}

// Walks a statement, or those in a block, whose variables end with it.
bool UnrolledBody::WalkScope(StmtId stmt, Stmts& out) {
  const std::size_t declared = declared_.size();
  const auto* block = As<Block>(program_, stmt);
  const bool goes_on = block ? WalkList(block->body, out) : Walk(stmt, out);
  LeaveScope(declared);
  return goes_on;
}

// Appends statements of an inner scope, as a block where they declare a variable.
void UnrolledBody::Append(const Stmts& inner, Stmts& out) {
  const bool is_scope = std::ranges::any_of(
      inner, [&](StmtId part) { return As<Declare>(program_, part) != nullptr; });
  if (is_scope)
    out.push_back(Builder(program_, program_.stmts[inner.front()].span).BlockOf(inner));
  else
    out.insert(out.end(), inner.begin(), inner.end());
}

bool UnrolledBody::Walk(StmtId stmt, Stmts& out) {
  const auto keep = [&] { out.push_back(stmt); };
  return Visit(Overloaded{
                   [&](const Block&) {
                     Stmts inner;
                     const bool goes_on = WalkScope(stmt, inner);
                     Append(inner, out);
                     return goes_on;
                   },
                   [&](const Declare& node) { return WalkDeclare(stmt, node, out); },
                   [&](const Evaluate& node) {
                     known_.Fold(node.expr, out);
                     if (!IsPure(program_, node.expr)) keep();
                     return true;
                   },
                   [&](const If& node) { return WalkIf(stmt, node, out); },
                   [&](const OneOf<For, While, DoWhile> auto&) { return WalkLoop(stmt, out); },
                   [&](const Switch&) { return WalkSwitch(stmt, out); },
                   [&](const Return& node) {
                     if (node.value) known_.Fold(node.value, out);
                     keep();
                     return false;
                   },
                   [&](const Break&) { return WalkExit(stmt, true, out); },
                   [&](const Continue&) { return WalkExit(stmt, false, out); },
                   [&](const Discard&) {
                     keep();
                     return true;
                   },
               },
               program_.stmts[stmt].node);
}

bool UnrolledBody::WalkDeclare(StmtId stmt, Declare node, Stmts& out) {
  if (node.init) known_.Fold(node.init, out);
  declared_.push_back(node.var);
  out.push_back(stmt);
  if (!node.init) return true;
  if (known_.IsTable(node.var)) {
    // The elements stay there for indices that are not known.
    if (const auto bits = ConstantBits(program_, node.init)) known_.now[node.var] = {*bits, true};
    return true;
  }
  known_.Assign(node.var, node.init);
  if (known_.now.contains(node.var)) program_.stmts[stmt].node = Declare{node.var, {}};
  return true;
}

bool UnrolledBody::WalkIf(StmtId stmt, If node, Stmts& out) {
  known_.Fold(node.condition, out);
  if (const auto bits = ConstantBits(program_, node.condition)) {
    const StmtId taken = bits->front() != 0 ? node.then : node.otherwise;
    if (!taken) return true;
    Stmts inner;
    const bool goes_on = WalkScope(taken, inner);
    Append(inner, out);
    return goes_on;
  }
  Stmts parts = {node.then};
  if (node.otherwise) parts.push_back(node.otherwise);
  const std::vector<bool> assigned = AssignedIn(program_, parts);
  for (const auto& [var, value] : Values(known_.now)) {
    if (assigned[var.index]) known_.Store(var, out);
  }
  ++branches_;
  const Values before = known_.now;
  Stmts then, otherwise;
  const bool then_goes_on = WalkScope(node.then, then);
  Values after_then = std::exchange(known_.now, before);
  const bool goes_on = !node.otherwise || WalkScope(node.otherwise, otherwise);
  --branches_;
  if (then_goes_on && goes_on)
    JoinBranches(after_then, otherwise, then);
  else if (then_goes_on)
    known_.now = std::move(after_then);
  Builder b(program_, program_.stmts[stmt].span);
  if (!then.empty() || !otherwise.empty()) {
    program_.stmts[stmt].node =
        If{node.condition, b.BlockOf(then), otherwise.empty() ? StmtId{} : b.BlockOf(otherwise)};
    out.push_back(stmt);
  } else if (!IsPure(program_, node.condition)) {
    out.push_back(b.Eval(node.condition));
  }
  return then_goes_on || goes_on;
}

// The targets have no `switch`, so it is refused: nothing is followed through it.
bool UnrolledBody::WalkSwitch(StmtId stmt, Stmts& out) {
  for (const auto& [var, value] : Values(known_.now)) known_.Store(var, out);
  known_.now.clear();
  out.push_back(stmt);
  return true;
}

bool UnrolledBody::WalkExit(StmtId stmt, bool is_break, Stmts& out) {
  Loop& loop = loops_.back();
  if (!loop.is_unrolled) {
    for (const VarId var : loop.assigned) known_.Store(var, out);
    out.push_back(stmt);
  } else if (branches_ == loop.branches) {
    (is_break ? loop.breaks_for_sure : loop.continues_for_sure) = true;
  } else {
    (is_break ? loop.breaks : loop.continues).push_back({stmt, known_.now});
    out.push_back(stmt);
  }
  return false;
}

// ---- where paths join

bool UnrolledBody::IsVisible(VarId var) const {
  return program_.vars[var].storage == Storage::kIn || std::ranges::count(declared_, var) > 0;
}

void UnrolledBody::LeaveScope(std::size_t declared) {
  for (; declared_.size() > declared; declared_.pop_back()) known_.Forget(declared_.back());
}

// Joins what is known at the end of a path, in known_, and of another one: what is not equal is
// stored at the ends and unknown after them.
void UnrolledBody::JoinBranches(const Values& other, Stmts& end, Stmts& other_end) {
  Values joined;
  for (const auto& [var, value] : known_.now) {
    const auto found = other.find(var);
    if (found != other.end() && found->second.bits == value.bits)
      joined[var] = {value.bits, value.is_stored && found->second.is_stored};
    else if (!value.is_stored)
      end.push_back(known_.StoreOf(var, value));
  }
  for (const auto& [var, value] : other) {
    if (!value.is_stored && !joined.contains(var)) other_end.push_back(known_.StoreOf(var, value));
  }
  known_.now = std::move(joined);
}

// The same for the exits of a loop or an iteration and, if `end` is given, the path in known_,
// whose statements it has. The variables that are in scope count.
void UnrolledBody::Join(Stmts* end, std::vector<Exit>& exits) {
  if (exits.empty()) return;
  Values joined = end ? known_.now : exits.front().values;
  for (auto each = joined.begin(); each != joined.end();) {
    bool is_equal = IsVisible(each->first);
    for (const Exit& exit : exits) {
      const auto found = exit.values.find(each->first);
      is_equal = is_equal && found != exit.values.end() && found->second.bits == each->second.bits;
      if (is_equal) each->second.is_stored &= found->second.is_stored;
    }
    each = is_equal ? std::next(each) : joined.erase(each);
  }
  const auto store = [&](const Values& values, Stmts& stmts) {
    for (const auto& [var, value] : values) {
      if (!value.is_stored && !joined.contains(var) && IsVisible(var))
        stmts.push_back(known_.StoreOf(var, value));
    }
  };
  for (const Exit& exit : exits) {
    Stmts stores;
    store(exit.values, stores);
    if (stores.empty()) continue;
    Builder b(program_, program_.stmts[exit.stmt].span);
    stores.push_back(program_.stmts.Add(Stmt(program_.stmts[exit.stmt])));
    program_.stmts[exit.stmt].node = Block{program_.stmt_lists.Add(stores)};
  }
  if (end) store(known_.now, *end);
  known_.now = std::move(joined);
}

}  // namespace clipc::legalize
