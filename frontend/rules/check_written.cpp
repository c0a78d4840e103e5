// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/check_written.h"

#include <algorithm>
#include <vector>

#include "base/overloaded.h"
#include "frontend/rules/written_messages.h"
#include "frontend/rules/written_walk.h"
#include "frontend/typing/constant.h"
#include "ir/access.h"
#include "ir/call_order.h"
#include "ir/walk.h"

namespace clipc::rules {

void WrittenWalk::Run() {
  const Function& function = program_.functions[function_];
  summary_.parameters.resize(function.parameters.size());
  for (const VarId parameter : function.parameters) {
    if (program_.vars[parameter].storage == Storage::kOut) Unwrite(parameter);
  }
  if (Walk(function.body) == Flow::kNext) Leave();
  if (!IsEntry()) ReportParameters();
  shared_.summaries[function_.index] = std::move(summary_);
}

// Reports the out parameters that are not written where the function returns.
void WrittenWalk::ReportParameters() {
  const std::vector<VarId>& parameters = program_.functions[function_].parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const VarId parameter = parameters[i];
    if (summary_.parameters[i].empty() || shared_.is_reported[parameter.index]) continue;
    const Var& var = program_.vars[parameter];
    const KeptVector<std::uint16_t> masks = shared_.slots.MasksOf(var.type);
    bool is_whole = true, is_any = false, is_safe = true;
    for (std::size_t slot = 0; slot < masks.size(); ++slot) {
      const WrittenComponents& written = summary_.parameters[i][slot];
      is_whole &= (masks[slot] & written.may) == masks[slot];
      is_any |= (masks[slot] & written.may) != 0;
      is_safe &= (masks[slot] & written.safe) == masks[slot];
    }
    if (!is_whole)
      ReportParameter(program_, var, is_any, shared_.diagnostics);
    else if (!is_safe)
      ReportPartly(var, shared_.diagnostics);
  }
}

// ---- statements

WrittenWalk::Flow WrittenWalk::WalkList(List<StmtId> list) {
  for (std::uint32_t i = 0; i < list.size; ++i) {
    const Flow flow = Walk(program_.stmt_lists[list][i]);
    if (flow != Flow::kNext) return flow;  // the rest cannot be reached
  }
  return Flow::kNext;
}

WrittenWalk::Flow WrittenWalk::Walk(StmtId stmt) {
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
                          [&](const Discard&) { return state_.MakeSafe(true), Flow::kNext; },
                          [&](const auto&) { return WalkLoop(stmt); },
                      },
                      program_.stmts[stmt].node);
}

WrittenWalk::Flow WrittenWalk::WalkIf(const If& node) {
  Visit(node.condition);
  if (const auto known = EvaluateInteger(program_, node.condition))
    return Walk(*known != 0 ? node.then : node.otherwise);
  const std::size_t mark = state_.Mark();
  ++choices_;
  const Flow then = Walk(node.then);
  const WrittenState::Changes one = state_.TakeSince(mark);
  const Flow otherwise = Walk(node.otherwise);
  --choices_;
  if (then == otherwise) {
    if (then == Flow::kReturn) return then;
    const WrittenState::Changes other = state_.TakeSince(mark);
    state_.Join(one, other, PointAfter(node.condition));
    return then;
  }
  const bool then_leaves = then == Flow::kReturn || otherwise == Flow::kNext;
  const WrittenState::Changes other = state_.TakeSince(mark);
  state_.Apply(then_leaves ? other : one);
  if (then == Flow::kJump || otherwise == Flow::kJump) {
    if (then != Flow::kReturn && otherwise != Flow::kReturn)
      state_.AddMay(then_leaves ? one : other);
  }
  state_.MakeSafe(false);
  return then_leaves ? otherwise : then;
}

JoinPoint WrittenWalk::PointAfter(ExprId condition) {
  return {loops_, choices_, &shared_.paths, condition};
}

WrittenWalk::Flow WrittenWalk::WalkSwitch(const Switch& node) {
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
  choices_ += known ? 0 : 1;
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
  choices_ -= known ? 0 : 1;
  if (known ? chosen == node.cases.size : !has_default) leave({});
  state_.JoinAll(std::move(left), exits, PointAfter(node.value));
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

WrittenWalk::Flow WrittenWalk::WalkLoop(StmtId stmt) {
  const std::size_t first = reads_.size();
  ++loops_;
  std::size_t mark = 0;
  const auto walk_body = [&](StmtId body, ExprId step) {
    mark = state_.Mark();
    ++choices_;
    Walk(body);
    if (step) Visit(step);
    --choices_;
  };
  clipc::Visit(Overloaded{
                   [&](const For& loop) {
                     WalkList(loop.init);
                     if (loop.condition) Visit(loop.condition);
                     walk_body(loop.body, loop.step);
                   },
                   [&](const While& loop) {
                     Visit(loop.condition);
                     walk_body(loop.body, {});
                   },
                   [&](const DoWhile& loop) { walk_body(loop.body, loop.condition); },
                   [](const auto&) {},
               },
               program_.stmts[stmt].node);
  --loops_;
  state_.LeaveLoop(state_.TakeSince(mark), PointAfter({}),
                   [&] { return shared_.paths.MayNotRun(stmt); });
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
  const KeptVector<WrittenComponents> values = ValueOf(node.init);
  if (!AreAllWritten(values)) Track(node.var);
  if (shared_.slots.IsTracked(node.var)) Write(shared_.slots.Whole(node.var), values);
}

void WrittenWalk::WalkReturn(ExprId value) {
  if (value && !IsEntry() && TypeOf(program_, value).IsNumeric()) {
    Visit(value);  // reports what is unwritten, so that callers need not
  } else if (value) {
    KeptVector<WrittenComponents> values = ValueOf(value);
    const std::size_t count = shared_.slots.CountOf(TypeIdOf(program_, value));
    values.resize(count, kAllWritten);
    if (!has_returned_) summary_.result.assign(count, {0, 0xffff, 0xffff});
    for (std::size_t i = 0; i < count; ++i) {
      summary_.result[i].may |= values[i].may;
      summary_.result[i].must &= values[i].must;
      summary_.result[i].safe &= values[i].safe;
    }
  }
  Leave();
}

// Notes the out parameters where the function returns.
void WrittenWalk::Leave() {
  const Function& function = program_.functions[function_];
  const bool has_result = program_.types[function.return_type].kind != TypeKind::kVoid;
  const std::vector<VarId>& parameters = function.parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (program_.vars[parameters[i]].storage != Storage::kOut) continue;
    const WrittenPlace place = shared_.slots.Whole(parameters[i]);
    KeptVector<WrittenComponents>& all = summary_.parameters[i];
    if (!has_returned_) all.assign(place.count, {0, 0xffff, 0xffff});
    for (std::size_t slot = 0; slot < place.count; ++slot) {
      const WrittenComponents& now = state_[place.first + slot];
      all[slot].may |= now.may;
      all[slot].must &= now.must;
      // A result may tell the caller which parameters it may read.
      all[slot].safe &= static_cast<std::uint16_t>(has_result ? now.safe | ~now.may : now.safe);
    }
  }
  has_returned_ = true;
}

void CheckWritten(Program& program, Diagnostics& diagnostics) {
  WrittenShared shared{program,
                       diagnostics,
                       WrittenSlots(program),
                       ValueCheck(program, diagnostics),
                       WrittenPaths(program),
                       KeptVector<WrittenSummary>(program.functions.size()),
                       KeptVector<bool>(program.vars.size()),
                       KeptVector<IoVar*>(program.vars.size())};
  for (IoVar& output : program.outputs) shared.outputs[output.var.index] = &output;
  WrittenState state;
  for (const FunctionId function : CalleesFirst(program))
    WrittenWalk(shared, state, function).Run();
}

}  // namespace clipc::rules
