// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/check_written.h"

#include <algorithm>
#include <span>
#include <vector>

#include "frontend/rules/check_values.h"
#include "frontend/rules/constant.h"
#include "frontend/rules/written.h"
#include "frontend/rules/written_messages.h"
#include "ir/access.h"
#include "ir/call_order.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

// What a function has written when it returns.
struct Summary {
  std::vector<WrittenComponents> result;                   // by slot of the type
  std::vector<std::vector<WrittenComponents>> parameters;  // empty for those that are not kOut
};

// How control leaves a statement.
enum class Flow : std::uint8_t { kNext, kJump, kReturn };  // kJump: break or continue

// What all functions share.
struct Shared {
  const Program& program;
  Diagnostics& diagnostics;
  WrittenSlots slots;
  ValueCheck values;
  std::vector<Summary> summaries;  // by FunctionId
  std::vector<bool> is_reported;   // by VarId
  std::vector<IoVar*> outputs;     // by VarId
};

bool AreAllWritten(std::span<const WrittenComponents> values) {
  return std::ranges::all_of(values, [](WrittenComponents value) { return value == kAllWritten; });
}

// Walks a function in the order in which it runs.
class WrittenWalk {
 public:
  WrittenWalk(Shared& shared, WrittenState& state, FunctionId function)
      : shared_(shared), program_(shared.program), state_(state), function_(function) {}

  void Run();

 private:
  // A read of what nothing before it in the text has written; the rest of a loop around it may.
  struct Read {
    WrittenPlace place;
    Span span;
  };

  bool IsMain() const { return function_ == program_.main; }
  bool IsEntry() const { return function_ == program_.entry; }

  // ---- statements
  Flow WalkList(List<StmtId> list);
  Flow Walk(StmtId stmt);
  Flow WalkIf(const If& node);
  Flow WalkSwitch(const Switch& node);
  std::uint32_t ArmOf(const Switch& node, std::int64_t value) const;
  Flow WalkLoop(StmtId stmt);
  void WalkDeclare(const Declare& node);
  void WalkReturn(ExprId value);
  void Leave();

  // ---- expressions
  void Visit(ExprId expr);
  bool VisitTarget(ExprId path);
  void VisitAssign(const Assign& node);
  void VisitCall(ExprId expr, const Call& node);
  void CheckRead(ExprId path);
  void Report(const Read& read);
  void Track(VarId var);
  void Unwrite(VarId var);
  void WriteTo(ExprId target, std::span<const WrittenComponents> values);
  void Write(const WrittenPlace& place, std::span<const WrittenComponents> values = {});
  // What the parts of a value are that an assignment copies; empty: all are written.
  std::vector<WrittenComponents> ValueOf(ExprId value);

  // ---- main
  void CheckOutput(const Assign& node);

  Shared& shared_;
  const Program& program_;
  WrittenState& state_;
  FunctionId function_;
  bool has_returned_ = false;
  int loops_ = 0;
  std::vector<Read> reads_;  // in loops that have not ended
  Summary summary_;
};

void WrittenWalk::Run() {
  const Function& function = program_.functions[function_];
  summary_.parameters.resize(function.parameters.size());
  for (const VarId parameter : function.parameters) {
    if (program_.vars[parameter].storage == Storage::kOut) Unwrite(parameter);
  }
  if (Walk(function.body) == Flow::kNext) Leave();
  for (std::size_t i = 0; i < function.parameters.size() && !IsEntry(); ++i) {
    const VarId parameter = function.parameters[i];
    if (summary_.parameters[i].empty() || shared_.is_reported[parameter.index]) continue;
    const Var& var = program_.vars[parameter];
    const std::vector<std::uint16_t> masks = shared_.slots.MasksOf(var.type);
    bool is_whole = true, is_any = false;
    for (std::size_t slot = 0; slot < masks.size(); ++slot) {
      is_whole &= (masks[slot] & summary_.parameters[i][slot].may) == masks[slot];
      is_any |= (masks[slot] & summary_.parameters[i][slot].may) != 0;
    }
    if (is_whole) continue;
    ReportParameter(program_, var, is_any, shared_.diagnostics);
  }
  shared_.summaries[function_.index] = std::move(summary_);
}

// ---- statements

Flow WrittenWalk::WalkList(List<StmtId> list) {
  for (std::uint32_t i = 0; i < list.size; ++i) {
    const Flow flow = Walk(program_.stmt_lists[list][i]);
    if (flow != Flow::kNext) return flow;  // the rest cannot be reached
  }
  return Flow::kNext;
}

Flow WrittenWalk::Walk(StmtId stmt) {
  if (!stmt) return Flow::kNext;
  return clipc::Visit(Overloaded{
                          [&](const Block& node) { return WalkList(node.body); },
                          [&](const Declare& node) { return WalkDeclare(node), Flow::kNext; },
                          [&](const Evaluate& node) { return Visit(node.expr), Flow::kNext; },
                          [&](const If& node) { return WalkIf(node); },
                          [&](const Switch& node) { return WalkSwitch(node); },
                          [&](const Return& node) {
                            WalkReturn(node.value);
                            return Flow::kReturn;
                          },
                          [&](const OneOf<Break, Continue> auto&) { return Flow::kJump; },
                          [&](const auto&) { return WalkLoop(stmt); },
                      },
                      program_.stmts[stmt].node);
}

Flow WrittenWalk::WalkIf(const If& node) {
  Visit(node.condition);
  if (const auto known = EvaluateInteger(program_, node.condition))
    return Walk(*known != 0 ? node.then : node.otherwise);
  const std::size_t mark = state_.Mark();
  const Flow then = Walk(node.then);
  const WrittenState::Changes one = state_.TakeSince(mark);
  const Flow otherwise = Walk(node.otherwise);
  if (then == Flow::kReturn) return otherwise;
  if (otherwise == Flow::kReturn) {
    state_.TakeSince(mark);
    state_.Apply(one);
    return then;
  }
  if (then != otherwise) {  // one of them jumps
    const WrittenState::Changes other = state_.TakeSince(mark);
    state_.Apply(then == Flow::kNext ? one : other);
    state_.AddMay(then == Flow::kNext ? other : one);
    return Flow::kNext;
  }
  state_.Join(one, state_.TakeSince(mark));
  return then;
}

Flow WrittenWalk::WalkSwitch(const Switch& node) {
  Visit(node.value);
  // What one arm declares, the arms after it may name, and control may come there without it.
  for (const SwitchCase& arm : program_.switch_cases[node.cases]) {
    for (const StmtId stmt : program_.stmt_lists[arm.body]) {
      if (const auto* declare = As<Declare>(program_, stmt)) Unwrite(declare->var);
    }
  }
  const std::size_t mark = state_.Mark();
  // The changes of all arms that control leaves the switch from.
  WrittenState::Changes left;
  std::size_t exits = 0;
  bool has_default = false;
  const auto leave = [&](const WrittenState::Changes& arm) {
    left.insert(left.end(), arm.begin(), arm.end());
    ++exits;
  };
  WrittenState::Changes falling;
  Flow flow = Flow::kJump;
  const auto known = EvaluateInteger(program_, node.value);
  const std::uint32_t chosen = known ? ArmOf(node, *known) : 0;
  for (std::uint32_t i = chosen; i < node.cases.size; ++i) {
    if (known && i > chosen && flow != Flow::kNext) break;
    const SwitchCase& arm = program_.switch_cases[node.cases][i];
    has_default |= arm.is_default;
    // An arm that the one before falls into begins with all that it may have written.
    if (flow == Flow::kNext) state_.AddMay(falling);
    flow = WalkList(arm.body);
    const bool is_last = i + 1 == node.cases.size;
    falling = state_.TakeSince(mark);
    if (flow == Flow::kJump || (is_last && flow == Flow::kNext)) leave(falling);
  }
  if (known ? chosen == node.cases.size : !has_default) leave({});
  state_.JoinAll(std::move(left), exits);
  return exits > 0 ? Flow::kNext : Flow::kReturn;
}

// The number of the arm that the value chooses; that of all arms where it chooses none.
std::uint32_t WrittenWalk::ArmOf(const Switch& node, std::int64_t value) const {
  std::uint32_t chosen = node.cases.size;
  for (std::uint32_t i = 0; i < node.cases.size; ++i) {
    const SwitchCase& arm = program_.switch_cases[node.cases][i];
    for (std::uint32_t l = 0; l < arm.labels.size; ++l) {
      if (EvaluateInteger(program_, program_.expr_lists[arm.labels][l]) == value) return i;
    }
    if (arm.is_default) chosen = i;
  }
  return chosen;
}

Flow WrittenWalk::WalkLoop(StmtId stmt) {
  const std::size_t first = reads_.size();
  ++loops_;
  // A loop runs at least once: fxc and dxc know the iterations of most loops.
  Flow body = Flow::kNext;
  clipc::Visit(Overloaded{
                   [&](const For& loop) {
                     WalkList(loop.init);
                     if (loop.condition) Visit(loop.condition);
                     body = Walk(loop.body);
                     if (loop.step) Visit(loop.step);
                   },
                   [&](const While& loop) {
                     Visit(loop.condition);
                     body = Walk(loop.body);
                   },
                   [&](const DoWhile& loop) {
                     body = Walk(loop.body);
                     Visit(loop.condition);
                   },
                   [](const auto&) {},
               },
               program_.stmts[stmt].node);
  --loops_;
  // What is written later in the loop may be written when a read runs again.
  std::size_t kept = first;
  for (std::size_t i = first; i < reads_.size(); ++i) {
    const Read read = reads_[i];
    if (state_[read.place.first].may & read.place.mask) continue;
    if (loops_ == 0) {
      Report(read);
    } else {
      reads_[kept++] = read;
    }
  }
  reads_.resize(loops_ == 0 ? first : kept);
  return Flow::kNext;
}

void WrittenWalk::WalkDeclare(const Declare& node) {
  if (!node.init) return Unwrite(node.var);
  const std::vector<WrittenComponents> values = ValueOf(node.init);
  if (!AreAllWritten(values)) Track(node.var);
  if (shared_.slots.IsTracked(node.var)) Write(shared_.slots.Whole(node.var), values);
}

void WrittenWalk::WalkReturn(ExprId value) {
  if (value && !IsEntry() && TypeOf(program_, value).IsNumeric()) {
    Visit(value);  // reports what is unwritten, so that callers need not
  } else if (value) {
    std::vector<WrittenComponents> values = ValueOf(value);
    const std::size_t count = shared_.slots.CountOf(TypeIdOf(program_, value));
    values.resize(count, kAllWritten);
    if (!has_returned_) summary_.result.assign(count, {0, 0xffff});
    for (std::size_t i = 0; i < count; ++i) {
      summary_.result[i].may |= values[i].may;
      summary_.result[i].must &= values[i].must;
    }
  }
  Leave();
}

// Notes the out parameters where the function returns.
void WrittenWalk::Leave() {
  const std::vector<VarId>& parameters = program_.functions[function_].parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (program_.vars[parameters[i]].storage != Storage::kOut) continue;
    const WrittenPlace place = shared_.slots.Whole(parameters[i]);
    std::vector<WrittenComponents>& all = summary_.parameters[i];
    if (!has_returned_) all.assign(place.count, {0, 0xffff});
    for (std::size_t slot = 0; slot < place.count; ++slot) {
      all[slot].may |= state_[place.first + slot].may;
      all[slot].must &= state_[place.first + slot].must;
    }
  }
  has_returned_ = true;
}

// ---- expressions

void WrittenWalk::Visit(ExprId expr) {
  clipc::Visit(Overloaded{
                   [&](const OneOf<VarRef, FieldRef, Index, Swizzle, MatrixSwizzle> auto&) {
                     if (VisitTarget(expr) && TypeOf(program_, expr).IsNumeric()) CheckRead(expr);
                   },
                   [&](const Unary& node) {
                     Visit(node.operand);
                     if (!ChangesOperand(node.op)) return;
                     WriteTo(node.operand, {});
                   },
                   [&](const Assign& node) { shared_.values.Check(node), VisitAssign(node); },
                   [&](const Call& node) { VisitCall(expr, node); },
                   [&](const Conditional& node) {
                     Visit(node.condition);
                     const auto known = EvaluateInteger(program_, node.condition);
                     if (known.value_or(1) != 0) Visit(node.when_true);
                     if (known.value_or(0) == 0) Visit(node.when_false);
                   },
                   [&](const IntrinsicCall& node) {
                     shared_.values.Check(node);
                     std::size_t i = 0;
                     for (const ExprId argument : program_.expr_lists[node.arguments]) {
                       if (!WritesArgument(node.op, i++)) {
                         Visit(argument);
                         continue;
                       }
                       VisitTarget(argument);
                       WriteTo(argument, {});
                     }
                   },
                   [&](const ObjectCall& node) {
                     for (const ExprId argument : program_.expr_lists[node.arguments])
                       Visit(argument);
                     if (node.has_clamp) Visit(ClampOf(program_, node));
                     if (node.has_texel) WriteTo(TexelOf(program_, node), {});
                   },
                   [&]<typename Node>(const Node& node) {
                     if constexpr (std::same_as<Node, Binary>) shared_.values.Check(node);
                     ForEachSlot(
                         node, [&](ExprId operand) { Visit(operand); },
                         [&](List<ExprId> list) {
                           for (const ExprId operand : program_.expr_lists[list]) Visit(operand);
                         });
                   },
               },
               program_.exprs[expr].node);
}

// Visits the indices of a path, and what it is a part of if that is not a variable. Returns whether
// it is a variable that is tracked.
bool WrittenWalk::VisitTarget(ExprId path) {
  return clipc::Visit(Overloaded{
                          [&](const VarRef& node) { return shared_.slots.IsTracked(node.var); },
                          [&](const OneOf<FieldRef, Swizzle, MatrixSwizzle> auto& node) {
                            return VisitTarget(node.base);
                          },
                          [&](const Index& node) {
                            const bool is_tracked = VisitTarget(node.base);
                            Visit(node.index);
                            return is_tracked;
                          },
                          [&](const auto&) { return Visit(path), false; },
                      },
                      program_.exprs[path].node);
}

void WrittenWalk::VisitAssign(const Assign& node) {
  if (IsMain()) CheckOutput(node);
  VisitTarget(node.target);
  if (!node.op) return WriteTo(node.target, ValueOf(node.value));
  Visit(node.value);
  if (TypeOf(program_, node.target).IsNumeric()) CheckRead(node.target);
  WriteTo(node.target, {});
}

void WrittenWalk::VisitCall(ExprId expr, const Call& node) {
  const Summary& summary = shared_.summaries[node.function.index];
  const bool is_of_entry = node.function == program_.entry;
  std::size_t i = 0;
  std::vector<std::pair<ExprId, std::size_t>> written;
  ForEachOperand(program_, expr, [&](ExprId argument) {
    const std::size_t number = i++;
    if (!WritesOperand(program_, expr, number)) return Visit(argument);
    VisitTarget(argument);
    written.emplace_back(argument, number);
  });
  for (const auto& [target, number] : written) {
    WriteTo(target, is_of_entry ? std::span<const WrittenComponents>(summary.parameters[number])
                                : std::span<const WrittenComponents>());
  }
}

std::vector<WrittenComponents> WrittenWalk::ValueOf(ExprId value) {
  const bool is_numeric = TypeOf(program_, value).IsNumeric();
  if (const auto* call = As<Call>(program_, value)) {
    Visit(value);
    return shared_.summaries[call->function.index].result;
  }
  const auto place =
      is_numeric && !As<VarRef>(program_, value) ? std::nullopt : shared_.slots.Find(value);
  const bool is_return = IsEntry() || !is_numeric;
  if (!place || place->is_coarse || !is_return) {
    Visit(value);
    return {};
  }
  VisitTarget(value);
  std::vector<WrittenComponents> values;
  for (std::size_t i = 0; i < place->count; ++i) values.push_back(state_[place->first + i]);
  return values;
}

void WrittenWalk::Track(VarId var) {
  shared_.slots.Track(var);
  state_.Grow(shared_.slots.size());
}

// Makes a variable what it is where it is declared without a value.
void WrittenWalk::Unwrite(VarId var) {
  Track(var);
  if (!shared_.slots.IsTracked(var)) return;
  const WrittenPlace place = shared_.slots.Whole(var);
  for (std::size_t i = 0; i < place.count; ++i) state_.Set(place.first + i, {});
}

// Gives the values to a path; no values: it is written.
void WrittenWalk::WriteTo(ExprId target, std::span<const WrittenComponents> values) {
  const VarId root = AreAllWritten(values) ? VarId{} : RootOf(program_, target);
  if (root) Track(root);
  if (const auto place = shared_.slots.Find(target)) Write(*place, values);
}

void WrittenWalk::Write(const WrittenPlace& place, std::span<const WrittenComponents> values) {
  if (place.count == 1 && (place.is_coarse || values.size() != 1))
    return state_.Add(place.first, place.mask);
  for (std::size_t i = 0; i < place.count; ++i)
    state_.Set(place.first + i, values.size() == place.count ? values[i] : kAllWritten);
}

void WrittenWalk::CheckRead(ExprId path) {
  if (IsMain()) return;  // CheckOutput has a message of its own
  const auto place = shared_.slots.Find(path);
  if (!place || place->count != 1 || place->mask == 0) return;
  if (state_[place->first].may & place->mask) return;
  if (shared_.is_reported[place->var.index]) return;
  const Read read{*place, program_.exprs[path].span};
  if (loops_ == 0) return Report(read);
  // One read of a slot is enough.
  const bool is_known = !reads_.empty() && reads_.back().place.first == place->first &&
                        reads_.back().place.mask == place->mask;
  if (!is_known) reads_.push_back(read);
}

void WrittenWalk::Report(const Read& read) {
  if (shared_.is_reported[read.place.var.index]) return;
  shared_.is_reported[read.place.var.index] = true;
  ReportRead(read.span, program_.vars[read.place.var], shared_.diagnostics);
}

// ---- main

void WrittenWalk::CheckOutput(const Assign& node) {
  const auto* target = As<VarRef>(program_, node.target);
  IoVar* output = target ? shared_.outputs[target->var.index] : nullptr;
  const auto place = output ? shared_.slots.Find(node.value) : std::nullopt;
  if (!place || place->count != 1) return;
  const WrittenComponents& written = state_[place->first];
  output->is_unwritten = (written.may & place->mask) == 0;
  if ((written.may & written.must & place->mask) == place->mask) return;
  output->may_be_unwritten = true;
  ReportOutput(program_, *output, written, place->mask, shared_.diagnostics);
}

}  // namespace

void CheckWritten(Program& program, Diagnostics& diagnostics) {
  Shared shared{program,
                diagnostics,
                WrittenSlots(program),
                ValueCheck(program, diagnostics),
                std::vector<Summary>(program.functions.size()),
                std::vector<bool>(program.vars.size()),
                std::vector<IoVar*>(program.vars.size())};
  for (IoVar& output : program.outputs) shared.outputs[output.var.index] = &output;
  WrittenState state;
  for (const FunctionId function : CalleesFirst(program))
    WrittenWalk(shared, state, function).Run();
}

}  // namespace clipc::rules
