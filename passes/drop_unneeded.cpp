// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/drop_unneeded.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/invariant.h"
#include "base/overloaded.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::passes {

using namespace ir;

namespace {

// The search for the statements that are needed. It begins with those that change more than local
// variables; what gives a value to a variable that a needed statement reads is needed too.
class Sweeper {
 public:
  explicit Sweeper(Program& program)
      : program_(program),
        effects_(program),
        needed_(program.stmts.size()),
        read_(program.vars.size()),
        named_(program.vars.size()) {
    for (const FunctionId id : program.functions.ids()) effects_.MayBeSkipped(id);
  }

  void Run() {
    // From the last statement to the first, one round finds all but what loops carry on.
    constexpr int kMostRounds = 16;
    const StmtId body = program_.functions[program_.main].body;
    for (int round = 0; round < kMostRounds; ++round) {
      is_changed_ = false;
      Mark(body);
      if (!is_changed_) return Sweep(body);
    }
  }

 private:
  // Marks what is needed in the statement. Returns whether it is needed itself.
  bool Mark(StmtId id) {
    if (!id) return false;
    const bool is_needed =
        Visit(Overloaded{
                  [&](const OneOf<Block> auto& node) { return MarkList(node.body); },
                  [&](const OneOf<If> auto& node) {
                    const bool otherwise = Mark(node.otherwise);
                    return Mark(node.then) || otherwise || !effects_.MayBeSkipped(node.condition);
                  },
                  [&](const OneOf<For> auto& node) {
                    const bool iterates = MarkLoop(id, node.body) || NeedsEffect(node.condition) ||
                                          NeedsEffect(node.step);
                    return MarkList(node.init) || iterates;
                  },
                  [&](const OneOf<While, DoWhile> auto& node) {
                    return MarkLoop(id, node.body) || NeedsEffect(node.condition);
                  },
                  [&](const OneOf<Switch> auto& node) {
                    bool any = !effects_.MayBeSkipped(node.value);
                    ForEachPart(
                        program_, id, [](ExprId) {}, [&](StmtId part) { any = Mark(part) || any; });
                    return any;
                  },
                  [&](const OneOf<Declare> auto& node) {
                    return bool{named_[node.var.index]} || NeedsEffect(node.init);
                  },
                  [&](const OneOf<Evaluate> auto& node) { return NeedsEffect(node.expr); },
                  // The loop that is left or goes on needs its jumps.
                  [&](const OneOf<Break, Continue> auto&) { return is_in_needed_loop_; },
                  [](const OneOf<Return, Discard> auto&) { return true; },
              },
              program_.stmts[id].node);
    if (is_needed) Need(id);
    return is_needed;
  }

  bool MarkList(List<StmtId> stmts) {
    bool any = false;
    for (std::uint32_t i = stmts.size; i > 0; --i)
      any = Mark(program_.stmt_lists[stmts][i - 1]) || any;
    return any;
  }

  bool MarkLoop(StmtId loop, StmtId body) {
    const bool outer = std::exchange(is_in_needed_loop_, needed_[loop.index]);
    const bool is_needed = Mark(body);
    is_in_needed_loop_ = outer;
    return is_needed;
  }

  // Whether the expression changes more than local variables that nothing needs.
  bool NeedsEffect(ExprId expr) {
    if (!expr || effects_.MayBeSkipped(expr)) return false;
    if (const auto* comma = As<Comma>(program_, expr))
      return NeedsEffect(comma->first) || NeedsEffect(comma->second);
    ExprId target, value;
    if (const auto* assign = As<Assign>(program_, expr)) {
      target = assign->target;
      value = assign->value;
    } else if (const auto* unary = As<Unary>(program_, expr)) {
      target = unary->operand;
    }
    if (!target || !effects_.MayBeSkipped(target)) return true;
    const VarId root = RootOf(program_, target);
    const bool is_local = root && program_.vars[root].storage == Storage::kLocal;
    return !is_local || read_[root.index] || NeedsEffect(value);
  }

  // Notes that the statement stays, and what its own expressions read. Those of a `switch` and of
  // the head of a `for` stay as a whole.
  void Need(StmtId id) {
    if (needed_[id.index]) return;
    needed_[id.index] = true;
    is_changed_ = true;
    const auto read = [&](ExprId root) { Read(root); };
    if (const auto* loop = As<For>(program_, id)) {
      for (std::uint32_t i = 0; i < loop->init.size; ++i) Need(program_.stmt_lists[loop->init][i]);
      if (loop->condition) read(loop->condition);
      if (loop->step) read(loop->step);
      return;
    }
    if (const auto* declare = As<Declare>(program_, id)) named_[declare->var.index] = true;
    const bool is_whole = As<Switch>(program_, id) != nullptr;
    ForEachPart(program_, id, read, [&](StmtId part) {
      if (is_whole) NeedAll(part);
    });
  }

  // Notes what the expression reads. Nobody reads the target of its own assignment.
  void Read(ExprId root) {
    const auto* assign = As<Assign>(program_, root);
    const auto* target =
        assign && !assign->op ? As<VarRef>(program_, RootRef(assign->target)) : nullptr;
    ForEachExpr(program_, root, [&](ExprId part) {
      const auto* ref = As<VarRef>(program_, part);
      if (!ref) return;
      named_[ref->var.index] = true;
      if (ref != target) read_[ref->var.index] = true;
    });
  }

  // The reference to a variable that a path starts at; none for another expression.
  ExprId RootRef(ExprId path) const {
    while (const ExprId whole = WholeOf(program_, path)) path = whole;
    return path;
  }

  void NeedAll(StmtId id) {
    ForEachStmt(program_, id, [&](StmtId part) { Need(part); });
  }

  // Removes what is not needed from the statement, which is.
  void Sweep(StmtId id) {
    if (!id || As<Switch>(program_, id)) return;
    if (const auto* block = As<Block>(program_, id)) {
      const List<StmtId> all = block->body;
      std::vector<StmtId> left;
      for (std::uint32_t i = 0; i < all.size; ++i) {
        const StmtId part = program_.stmt_lists[all][i];
        if (!needed_[part.index]) continue;
        Sweep(part);
        left.push_back(part);
      }
      if (left.size() < all.size)
        program_.stmts[id].node = Block{program_.stmt_lists.Add(std::span<const StmtId>(left))};
      return;
    }
    if (auto* branch = std::get_if<If>(&program_.stmts[id].node);
        branch && branch->otherwise && !needed_[branch->otherwise.index])
      branch->otherwise = {};
    ForEachPart(
        program_, id, [](ExprId) {},
        [&](StmtId part) {
          if (needed_[part.index]) return Sweep(part);
          program_.stmts[part].node = Block{};
        });
  }

  Program& program_;
  Effects effects_;           // while nothing is removed
  std::vector<bool> needed_;  // by StmtId
  std::vector<bool> read_;    // by VarId: a needed statement reads it
  std::vector<bool> named_;   // by VarId: one reads it or gives it a value
  bool is_in_needed_loop_ = false;
  bool is_changed_ = false;
};

}  // namespace

void DropUnneeded(Program& program) {
  CLIPC_CHECK(program.form == Form::kInlined);
  Sweeper(program).Run();
}

}  // namespace clipc::passes
