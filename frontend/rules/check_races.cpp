// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/check_races.h"

#include <set>
#include <vector>

#include "base/overloaded.h"
#include "ir/access.h"
#include "ir/call_order.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

// Walks functions in the order of their text, and knows what has been written since all threads
// waited.
class RaceCheck {
 public:
  RaceCheck(const Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics), calls_(program.functions.size()) {}

  void Run() {
    for (const FunctionId function : CalleesFirst(program_)) {
      written_.clear();
      Walk(program_.functions[function].body);
      calls_[function.index] = {written_, waited_};
      waited_ = false;
    }
  }

 private:
  // What a function has written when it returns, since it last waited, if it does.
  struct Called {
    std::set<VarId> written;
    bool waits = false;
  };

  // What the threads of a group share and may write, at the root of the path; none for the rest.
  VarId Shared(ExprId path) const {
    const VarId root = path ? RootOf(program_, path) : VarId{};
    if (!root) return {};
    const Type& type = program_.types[program_.types.Innermost(program_.vars[root].type)];
    const bool is_object = type.kind == TypeKind::kObject && IsWritable(type.object);
    return is_object || program_.vars[root].storage == Storage::kShared ? root : VarId{};
  }

  // What the condition itself reads of that.
  std::set<VarId> ReadIn(ExprId condition) const {
    std::set<VarId> read;
    if (!condition) return read;
    ForEachExpr(program_, condition, [&](ExprId part) {
      const auto* ref = As<VarRef>(program_, part);
      if (ref && Shared(part)) read.insert(ref->var);
    });
    return read;
  }

  void Value(ExprId value) {
    if (!value) return;
    ForEachExpr(program_, value, [&](ExprId part) {
      ForEachWrite(program_, part, [&](ExprId target) { Written(target); });
      const auto* access = As<ObjectCall>(program_, part);
      if (access && WritesObject(access->op))
        Written(OperandOf(program_, *access, OperandKind::kObject));
      if (const auto* call = As<Call>(program_, part)) {
        const Called& called = calls_[call->function.index];
        if (called.waits) Waited();
        written_.insert(called.written.begin(), called.written.end());
      }
      const auto* intrinsic = As<IntrinsicCall>(program_, part);
      if (!intrinsic || !WaitsForGroup(intrinsic->op)) return;
      for (Governed& governed : governed_) {
        if (!governed.wait) governed.wait = part, governed.before = written_;
      }
      Waited();
    });
  }

  void Written(ExprId target) {
    if (const VarId var = Shared(target)) written_.insert(var);
  }
  void Waited() {
    written_.clear();
    waited_ = true;
  }

  // Walks what the condition decides about: `text`.
  template <typename Text>
  void Decided(ExprId condition, bool is_loop, const Text& text) {
    const std::set<VarId> read = ReadIn(condition);
    const std::set<VarId> at_first = written_;
    governed_.push_back({});
    text();
    const Governed governed = governed_.back();
    governed_.pop_back();
    if (!governed.wait) return;
    for (const VarId var : read) {
      const bool races = at_first.contains(var) || governed.before.contains(var) ||
                         (is_loop && written_.contains(var));
      if (!races || !reported_.insert(governed.wait).second) continue;
      const auto& call = std::get<IntrinsicCall>(program_.exprs[governed.wait].node);
      diagnostics_.Report(program_.exprs[governed.wait].span, diag::WaitMayRace, NameOf(call.op),
                          program_.vars[var].name);
    }
  }

  void Walk(List<StmtId> list) {
    for (const StmtId id : program_.stmt_lists[list]) Walk(id);
  }

  void Walk(StmtId id) {
    if (!id) return;
    Visit(Overloaded{
              [&](const Block& node) { Walk(node.body); },
              [&](const Declare& node) { Value(node.init); },
              [&](const Evaluate& node) { Value(node.expr); },
              [&](const If& node) {
                Value(node.condition);
                Decided(node.condition, false, [&] { Walk(node.then), Walk(node.otherwise); });
              },
              [&](const Switch& node) {
                Value(node.value);
                Decided(node.value, false, [&] {
                  for (const SwitchCase& arm : program_.switch_cases[node.cases]) Walk(arm.body);
                });
              },
              [&](const For& node) {
                Walk(node.init);
                Decided(node.condition, true, [&] { Walk(node.body), Value(node.step); });
              },
              [&](const While& node) { Decided(node.condition, true, [&] { Walk(node.body); }); },
              [&](const DoWhile& node) { Decided(node.condition, true, [&] { Walk(node.body); }); },
              [&](const Return& node) { Value(node.value); },
              [](const auto&) {},
          },
          program_.stmts[id].node);
  }

  // A branch or a loop around the place: the first wait in it, and what it has written before that.
  struct Governed {
    ExprId wait;
    std::set<VarId> before;
  };

  const Program& program_;
  Diagnostics& diagnostics_;
  std::vector<Called> calls_;  // by FunctionId
  std::vector<Governed> governed_;
  std::set<VarId> written_;  // since the last wait
  std::set<ExprId> reported_;
  bool waited_ = false;
};

}  // namespace

void CheckRaces(const Program& program, Diagnostics& diagnostics) {
  RaceCheck(program, diagnostics).Run();
}

}  // namespace clipc::rules
