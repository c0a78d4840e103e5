// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/wanted_values.h"

#include <cstddef>

#include "frontend/rules/constant.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

// Whether a `break` or `continue` in the statement ends a loop, or a turn of one, around it.
bool Leaves(const Program& program, StmtId stmt, bool in_switch) {
  if (As<Break>(program, stmt)) return !in_switch;
  if (As<Continue>(program, stmt)) return true;
  if (As<For>(program, stmt) || As<While>(program, stmt) || As<DoWhile>(program, stmt))
    return false;
  bool leaves = false;
  const bool is_switch = As<Switch>(program, stmt) != nullptr;
  ForEachPart(
      program, stmt, [](ExprId) {},
      [&](StmtId part) { leaves = leaves || Leaves(program, part, in_switch || is_switch); });
  return leaves;
}

}  // namespace

std::uint32_t FirstOffset(ObjectOp op) {
  using enum ObjectOp;
  switch (op) {
    case kSampleLevel:
    case kSampleCmpLevelZero: return 4;
    case kSampleGrad: return 5;
    case kTextureLoad: return 3;
    default: return IsGather(op) ? 3 : ~0u;
  }
}

bool IsLiteralOffset(const Program& program, ExprId offset) {
  return As<Literal>(program, offset) || IsLiteralList(program, offset);
}

WantedValues::WantedValues(const Program& program)
    : program_(program), vars_(program.vars.size()), functions_(program.functions.size()) {
  FindOffsets();
  if (is_empty_) return;
  std::vector<StmtId> bodies;
  for (const FunctionId id : program.functions.ids()) bodies.push_back(program.functions[id].body);
  assigned_ = AssignedIn(program, bodies);
  Flows flows{std::vector<std::vector<ExprId>>(program.vars.size()),
              std::vector<std::vector<FunctionId>>(program.functions.size())};
  for (const FunctionId id : program.functions.ids()) Collect(id, flows);
  FollowVars(flows);
  FollowFunctions(flows);
}

void WantedValues::FindOffsets() {
  if (!program_.calls_objects) return;
  for (const FunctionId id : program_.functions.ids()) {
    ForEachExpr(program_, program_.functions[id].body, [&](ExprId expr) {
      const auto* call = As<ObjectCall>(program_, expr);
      if (!call) return;
      const auto arguments = program_.expr_lists[call->arguments];
      for (std::size_t i = FirstOffset(call->op); i < arguments.size(); ++i) {
        if (IsLiteralOffset(program_, arguments[i])) continue;
        is_empty_ = false;
        functions_[id.index] = true;
        Want(arguments[i]);
      }
    });
  }
}

void WantedValues::Want(ExprId expr) {
  if (!expr) return;
  ForEachExpr(program_, expr, [&](ExprId part) {
    const auto* ref = As<VarRef>(program_, part);
    if (!ref || vars_[ref->var.index]) return;
    vars_[ref->var.index] = true;
    waiting_.push_back(ref->var);
  });
}

void WantedValues::Collect(FunctionId function, Flows& flows) const {
  const StmtId body = program_.functions[function].body;
  ForEachStmt(program_, body, [&](StmtId stmt) {
    if (const auto* declare = As<Declare>(program_, stmt)) {
      flows.values[declare->var.index].push_back(declare->init);
    } else if (const auto* loop = As<For>(program_, stmt)) {
      ExprId start;
      const VarId counter = CounterOf(*loop, start);
      if (!counter) return;
      for (const ExprId part : {start, loop->condition, loop->step})
        flows.values[counter.index].push_back(part);
    }
  });
  ForEachExpr(program_, body, [&](ExprId expr) {
    const auto* call = As<Call>(program_, expr);
    if (!call) return;
    flows.callers[call->function.index].push_back(function);
    const std::vector<VarId>& parameters = program_.functions[call->function].parameters;
    const auto arguments = program_.expr_lists[call->arguments];
    for (std::size_t i = 0; i < arguments.size(); ++i)
      flows.values[parameters[i].index].push_back(arguments[i]);
  });
}

void WantedValues::FollowVars(const Flows& flows) {
  while (!waiting_.empty()) {
    const VarId var = waiting_.back();
    waiting_.pop_back();
    for (const ExprId value : flows.values[var.index]) Want(value);
  }
}

void WantedValues::FollowFunctions(const Flows& flows) {
  std::vector<FunctionId> waiting;
  for (const FunctionId id : program_.functions.ids()) {
    if (Has(id)) waiting.push_back(id);
  }
  while (!waiting.empty()) {
    const FunctionId callee = waiting.back();
    waiting.pop_back();
    for (const FunctionId caller : flows.callers[callee.index]) {
      if (Has(caller)) continue;
      functions_[caller.index] = true;
      waiting.push_back(caller);
    }
  }
}

VarId WantedValues::CounterOf(const For& loop, ExprId& start) const {
  if (loop.init.size != 1) return {};
  const StmtId first = program_.stmt_lists[loop.init][0];
  if (const auto* declared = As<Declare>(program_, first)) {
    start = declared->init;
    return start ? declared->var : VarId{};
  }
  const Assign* set = AsAssignment(program_, first);
  const auto* variable = set ? As<VarRef>(program_, set->target) : nullptr;
  if (!variable || program_.vars[variable->var].storage != Storage::kLocal) return {};
  start = set->value;
  return variable->var;
}

bool WantedValues::IsPlain(const For& loop) const {
  return IsPure(program_, loop.condition) && !Leaves(program_, loop.body, false);
}

ExprId WantedValues::NextOf(Program& program, ExprId step, VarId counter) {
  Builder at(program, program.exprs[step].span);
  const auto is_counter = [&](ExprId expr) {
    const auto* ref = As<VarRef>(program, expr);
    return ref && ref->var == counter;
  };
  const TypeId type = program.vars[counter].type;
  if (const auto* unary = As<Unary>(program, step)) {
    if (!ChangesOperand(unary->op) || !is_counter(unary->operand)) return {};
    const bool is_up = unary->op == UnaryOp::kPreIncrement || unary->op == UnaryOp::kPostIncrement;
    const ExprId one = at.LiteralOf(program.types[type].scalar, 1);
    return at.BinaryOf(is_up ? BinaryOp::kAdd : BinaryOp::kSub, at.Ref(counter), one);
  }
  const auto* assign = As<Assign>(program, step);
  if (!assign || !is_counter(assign->target) || !IsPure(program, assign->value)) return {};
  const Assign node = *assign;
  const ExprId value = Clone(program, node.value);
  return node.op ? at.BinaryOf(*node.op, at.Ref(counter), value) : value;
}

}  // namespace clipc::rules
