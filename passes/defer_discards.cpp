// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/defer_discards.h"

#include <algorithm>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::passes {

using namespace ir;

namespace {

// The search for discards that must wait: it follows the program backwards, with the answer whether
// neighbours may be asked after a place.
class Search {
 public:
  explicit Search(const Program& program)
      : program_(program),
        asks_(program.functions.size(), Answer::kUnknown),
        asked_after_(program.functions.size()) {}

  std::vector<StmtId> Run() {
    // Callers come before the functions that they call, so all places of a call are known.
    std::vector<FunctionId> order;
    std::vector<bool> seen(program_.functions.size());
    Order(program_.main, seen, order);
    for (auto function = order.rbegin(); function != order.rend(); ++function)
      Before(program_.functions[*function].body, asked_after_[function->index]);
    return std::move(waiting_);
  }

 private:
  enum class Answer : std::uint8_t { kUnknown, kNo, kYes };

  // Appends the functions that `function` reaches, callees before their callers.
  void Order(FunctionId function, std::vector<bool>& seen, std::vector<FunctionId>& order) {
    if (seen[function.index]) return;
    seen[function.index] = true;
    ForEachExpr(program_, program_.functions[function].body, [&](ExprId id) {
      if (const auto* call = As<Call>(program_, id)) Order(call->function, seen, order);
    });
    order.push_back(function);
    const bool asks = AnyExpr(program_, program_.functions[function].body,
                              [&](ExprId id) { return AsksItself(id); });
    asks_[function.index] = asks ? Answer::kYes : Answer::kNo;
  }

  bool AsksItself(ExprId id) const {
    const auto* call = As<Call>(program_, id);
    return AsksNeighbours(program_, id) || (call && asks_[call->function.index] == Answer::kYes);
  }
  bool Asks(ExprId expr) const {
    return expr && AnyExpr(program_, expr, [&](ExprId id) { return AsksItself(id); });
  }
  bool Asks(StmtId stmt) const {
    return stmt && AnyExpr(program_, stmt, [&](ExprId id) { return AsksItself(id); });
  }

  // Returns whether neighbours may be asked from the expression on, and tells the functions that it
  // calls. What else the expression evaluates may come after a call.
  bool Before(ExprId expr, bool after) {
    if (!expr) return after;
    after = after || Asks(expr);
    ForEachExpr(program_, expr, [&](ExprId id) {
      const auto* call = As<Call>(program_, id);
      if (call && after) asked_after_[call->function.index] = true;
    });
    return after;
  }

  bool Before(List<StmtId> list, bool after) {
    for (std::uint32_t i = list.size; i-- > 0;) after = Before(program_.stmt_lists[list][i], after);
    return after;
  }

  // Returns whether neighbours may be asked from the statement on, when `after` says whether they
  // may be after it.
  bool Before(StmtId id, bool after) {
    if (!id) return after;
    return Visit(Overloaded{
                     [&](const Block& node) { return Before(node.body, after); },
                     [&](const Declare& node) { return Before(node.init, after); },
                     [&](const Evaluate& node) { return Before(node.expr, after); },
                     [&](const If& node) {
                       const bool then = Before(node.then, after);
                       const bool otherwise = Before(node.otherwise, after);
                       return Before(node.condition, then || otherwise);
                     },
                     [&](const For& node) { return Before(node.init, Loop(id, after)); },
                     [&](const OneOf<While, DoWhile> auto&) { return Loop(id, after); },
                     [&](const Switch& node) {
                       bool any = after || Asks(id);
                       for (const SwitchCase& arm : program_.switch_cases[node.cases])
                         Before(arm.body, any);
                       return Before(node.value, any);
                     },
                     [&](const Return& node) { return Before(node.value, after); },
                     [&](const Discard&) {
                       if (after) waiting_.push_back(id);
                       return after;
                     },
                     [&](const OneOf<Break, Continue> auto&) { return after; },
                 },
                 program_.stmts[id].node);
  }

  // All parts of a loop may come after each of its parts.
  bool Loop(StmtId id, bool after) {
    const bool any = after || Asks(id);
    ForEachPart(
        program_, id, [&](ExprId expr) { Before(expr, any); },
        [&](StmtId part) { Before(part, any); });
    return any;
  }

  const Program& program_;
  std::vector<Answer> asks_;       // by FunctionId: whether its body, or a callee's, asks
  std::vector<bool> asked_after_;  // by FunctionId: whether any of its callers may ask after it
  std::vector<StmtId> waiting_;
};

}  // namespace

void DeferDiscards(Program& program) {
  CLIPC_CHECK(program.form == Form::kInlined);
  if (!clipc::InfoOf(program.stage).draws_pixels) return;
  const std::vector<StmtId> waiting = Search(program).Run();
  if (waiting.empty()) return;
  Builder b(program);
  program.defers_discards = true;
  const TypeId type = program.types.Make(Scalar::kBool);
  const VarId flag = program.vars.Add(
      {.name = "is_discarded", .type = type, .storage = Storage::kStatic, .init = b.Bool(false)});
  program.globals.push_back(flag);
  for (const StmtId id : waiting)
    program.stmts[id].node = Evaluate{b.AssignTo(b.Ref(flag), b.Bool(true))};
  const StmtId discard = b.Stmt(Discard{});
  const StmtId last = b.Stmt(If{b.Ref(flag), b.BlockOf({&discard, 1}), {}});
  AppendToBody(program, program.main, {&last, 1});
}

}  // namespace clipc::passes
