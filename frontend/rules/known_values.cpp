// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/known_values.h"

#include <ranges>

#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

// The variable that a `for` loop counts with: the one that its head declares or sets.
VarId CounterOf(const Program& program, const For& loop, ExprId& start) {
  if (loop.init.size != 1) return {};
  const StmtId first = program.stmt_lists[loop.init][0];
  if (const auto* declared = As<Declare>(program, first)) {
    start = declared->init;
    return declared->var;
  }
  const Assign* set = AsAssignment(program, first);
  const auto* variable = set ? As<VarRef>(program, set->target) : nullptr;
  if (!variable || program.vars[variable->var].storage != Storage::kLocal) return {};
  start = set->value;
  return variable->var;
}

}  // namespace

KnownValues::KnownValues(const Program& program) : program_(program), known_(program.vars.size()) {
  std::vector<StmtId> bodies;
  for (const FunctionId id : program.functions.ids()) bodies.push_back(program.functions[id].body);
  assigned_ = AssignedIn(program, bodies);
  for (const FunctionId id : program.functions.ids()) {
    for (const VarId parameter : program.functions[id].parameters) {
      known_[parameter.index] = id != program.entry && !assigned_[parameter.index] &&
                                program.vars[parameter].storage == Storage::kIn;
    }
  }
  // Callers stand after what they call, so one round is enough for most programs.
  do {
    changed_ = false;
    for (auto i = static_cast<std::uint32_t>(bodies.size()); i > 0; --i) Read(bodies[i - 1]);
  } while (changed_);
}

bool KnownValues::Has(ExprId expr) const {
  return expr && !AnyExpr(program_, expr, [&](ExprId part) {
           const Expr& node = program_.exprs[part];
           if (const auto* ref = std::get_if<VarRef>(&node.node)) {
             return !known_[ref->var.index] &&
                    program_.vars[ref->var].storage != Storage::kConstant;
           }
           bool writes = std::holds_alternative<Call>(node.node) ||
                         std::holds_alternative<ObjectCall>(node.node);
           ForEachWrite(program_, part, [&](ExprId) { writes = true; });
           return writes;
         });
}

void KnownValues::Read(StmtId stmt) {
  if (const auto* loop = As<For>(program_, stmt)) ReadLoop(*loop);
  ForEachPart(
      program_, stmt, [&](ExprId expr) { ReadCalls(expr); }, [&](StmtId part) { Read(part); });
  if (const auto* declared = As<Declare>(program_, stmt); declared && declared->init) {
    const std::uint32_t variable = declared->var.index;
    known_[variable] = (known_[variable] || !assigned_[variable]) && Has(declared->init);
  }
}

// Assumes that the counter is known, and takes that back if the head then computes with anything
// unknown, or the body sets the counter.
void KnownValues::ReadLoop(const For& loop) {
  ExprId start;
  const VarId counter = CounterOf(program_, loop, start);
  if (!counter || !loop.condition || !loop.step || !Has(start)) return;
  known_[counter.index] = true;
  bool is_counted = Has(loop.condition);
  std::size_t writes = 0;
  ForEachExpr(program_, loop.step, [&](ExprId part) {
    ForEachWrite(program_, part, [&](ExprId target) {
      const auto* ref = As<VarRef>(program_, target);
      is_counted = is_counted && ref && ref->var == counter;
      ++writes;
    });
    if (const auto* assign = As<Assign>(program_, part)) is_counted &= Has(assign->value);
  });
  const StmtId body[] = {loop.body};
  known_[counter.index] = is_counted && writes == 1 && !AssignedIn(program_, body)[counter.index];
}

// The parameters of what is called: an argument that is not known makes its parameter unknown.
void KnownValues::ReadCalls(ExprId expr) {
  ForEachExpr(program_, expr, [&](ExprId part) {
    const auto* call = As<Call>(program_, part);
    if (!call) return;
    const std::vector<VarId>& parameters = program_.functions[call->function].parameters;
    for (std::uint32_t i = 0; i < call->arguments.size; ++i) {
      const std::uint32_t parameter = parameters[i].index;
      if (!known_[parameter] || Has(program_.expr_lists[call->arguments][i])) continue;
      known_[parameter] = false;
      changed_ = true;
    }
  });
}

}  // namespace clipc::rules
