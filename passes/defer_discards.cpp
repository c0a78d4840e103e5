// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/defer_discards.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::passes {

using namespace ir;

namespace {

// Returns a function that discards where clip() of a value of this type does.
FunctionId ClipFunction(Program& program, TypeId type) {
  Builder b(program);
  const VarId value = program.vars.Add({.name = "value", .type = type, .storage = Storage::kIn});
  const StmtId discard = b.Stmt(Discard{});
  const ExprId condition = b.ClipsAt(b.Ref(value));
  const StmtId test = b.Stmt(If{condition, b.BlockOf({&discard, 1}), {}});
  return program.functions.Add({"clip", program.types.Void(), {value}, b.BlockOf({&test, 1}), {}});
}

// Makes each clip() that is a part of an expression a call of a function.
void CallClipFunctions(Program& program, std::span<const ExprId> clips) {
  std::map<std::uint32_t, FunctionId> functions;  // by TypeId of the value
  for (const ExprId clip : clips) {
    const auto& call = std::get<IntrinsicCall>(program.exprs[clip].node);
    const ExprId value = program.expr_lists[call.arguments][0];
    const TypeId type = TypeIdOf(program, value);
    FunctionId& function = functions[type.index];
    if (!function) function = ClipFunction(program, type);
    Builder b(program, program.exprs[clip].span);
    program.exprs[clip].node = program.exprs[b.CallOf(function, {&value, 1})].node;
  }
}

// Keeps the stores and atomic operations of a pixel whose discard waits from happening after it.
class StoreGuard {
 public:
  StoreGuard(Program& program, VarId flag) : program_(program), flag_(flag) {}

  void Run() {
    for (const FunctionId function : program_.functions.ids()) {
      ForEachStmt(program_, program_.functions[function].body, [&](StmtId id) { Statement(id); });
      ForEachExpr(program_, program_.functions[function].body, [&](ExprId id) { Value(id); });
    }
    for (const StmtId id : stores_) Guard(id);
    for (const ExprId id : values_) Guard(id);
  }

 private:
  void Statement(StmtId id) {
    const auto* evaluate = As<Evaluate>(program_, id);
    if (!evaluate || !IsStore(evaluate->expr)) return;
    stores_.push_back(id);
    ForEachExpr(program_, evaluate->expr, [&](ExprId part) { in_stores_.insert(part); });
  }
  // Whether a statement's expression writes an object; nothing uses the value that it may have.
  bool IsStore(ExprId id) const {
    const auto* call = As<ObjectCall>(program_, id);
    return call && WritesObject(call->op);
  }
  void Value(ExprId id) {
    const auto* call = As<ObjectCall>(program_, id);
    if (call && WritesObject(call->op) && !in_stores_.contains(id)) values_.push_back(id);
  }

  void Guard(StmtId id) {
    Builder b(program_, program_.stmts[id].span);
    const StmtId store = b.Eval(std::get<Evaluate>(program_.stmts[id].node).expr);
    const ExprId is_alive = b.UnaryOf(UnaryOp::kNot, b.Ref(flag_));
    program_.stmts[id].node = If{is_alive, b.BlockOf({&store, 1}), {}};
  }
  // The value of an atomic operation that does not happen is undefined. It is zero here, and of the
  // decrement of a counter one, since it is the index of an element once one is taken off. A store
  // has no value; neither GLSL nor SPIR-V chooses between operands without one.
  void Guard(ExprId id) {
    const TypeId type = TypeIdOf(program_, id);
    Builder b(program_, program_.exprs[id].span);
    const ObjectCall call = std::get<ObjectCall>(program_.exprs[id].node);
    const ExprId atomic = b.Add(type, call);
    if (type == program_.types.Void()) {
      program_.exprs[id].type = program_.types.Make(Scalar::kBool);
      const ExprId stored = b.CommaOf(atomic, b.Bool(true));
      program_.exprs[id].node = Conditional{b.Ref(flag_), b.Bool(false), stored};
      return;
    }
    const auto* added = As<Literal>(program_, OperandOf(program_, call, OperandKind::kValue));
    const bool counts_down = call.op == ObjectOp::kAtomicAdd && added && added->bits == ~0u &&
                             IsCounter(OperandOf(program_, call, OperandKind::kObject));
    const ExprId lost = counts_down ? b.Uint(1) : b.ZeroOf(type);
    program_.exprs[id].node = Conditional{b.Ref(flag_), lost, atomic};
  }

  bool IsCounter(ExprId object) const {
    const VarId root = RootOf(program_, object);
    return std::ranges::any_of(program_.resources, [&](const Resource& resource) {
      return resource.var == root && resource.counter_of;
    });
  }

  Program& program_;
  VarId flag_;
  std::vector<StmtId> stores_;
  std::set<ExprId> in_stores_;
  std::vector<ExprId> values_;
};

// Makes IsHelperLane() true in a pixel whose discard waits.
void TellHelpers(Program& program, VarId flag) {
  const auto input = std::ranges::find(program.inputs, Builtin::kHelperLane, &IoVar::builtin);
  if (input == program.inputs.end()) return;
  std::vector<ExprId> reads;
  for (const FunctionId function : program.functions.ids()) {
    ForEachExpr(program, program.functions[function].body, [&](ExprId id) {
      const auto* ref = As<VarRef>(program, id);
      if (ref && ref->var == input->var) reads.push_back(id);
    });
  }
  for (const ExprId id : reads) {
    Builder b(program, program.exprs[id].span);
    const ExprId either = b.BinaryOf(BinaryOp::kLogicalOr, b.Ref(input->var), b.Ref(flag));
    program.exprs[id].node = program.exprs[either].node;
  }
}

// The search for discards that must wait: it follows the program backwards, with the answer whether
// neighbours may be asked after a place.
class Search {
 public:
  explicit Search(const Program& program)
      : program_(program),
        asks_(program.functions.size(), Answer::kUnknown),
        asked_after_(program.functions.size()) {}

  // The calls of clip() in expressions, once Run is done.
  const std::vector<ExprId>& clips() const { return clips_; }

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
      const auto* intrinsic = As<IntrinsicCall>(program_, id);
      if (intrinsic && intrinsic->op == CommonIntrinsic::kClip) clips_.push_back(id);
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
  std::vector<ExprId> clips_;
};

}  // namespace

void DeferDiscards(Program& program) {
  CLIPC_CHECK(program.form == Form::kInlined);
  if (!clipc::InfoOf(program.stage).draws_pixels) return;
  const auto is_clip = [](const IntrinsicCall& call) { return call.op == CommonIntrinsic::kClip; };
  if (!MayHaveStmt<Discard>(program) && !MayHaveExpr<IntrinsicCall>(program, is_clip)) return;
  Search search(program);
  std::vector<StmtId> waiting = search.Run();
  if (!search.clips().empty()) {
    CallClipFunctions(program, search.clips());
    waiting = Search(program).Run();
  }
  if (waiting.empty()) return;
  Builder b(program);
  const TypeId type = program.types.Make(Scalar::kBool);
  const VarId flag = program.vars.Add(
      {.name = "is_discarded", .type = type, .storage = Storage::kStatic, .init = b.Bool(false)});
  program.globals.push_back(flag);
  for (const StmtId id : waiting)
    program.stmts[id].node = Evaluate{b.AssignTo(b.Ref(flag), b.Bool(true))};
  StoreGuard(program, flag).Run();
  TellHelpers(program, flag);
  const StmtId discard = b.Stmt(Discard{});
  const StmtId last = b.Stmt(If{b.Ref(flag), b.BlockOf({&discard, 1}), {}});
  AppendToBody(program, program.main, {&last, 1});
}

}  // namespace clipc::passes
