// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/counted_loop.h"

#include <span>

#include "base/operators.h"
#include "ir/access.h"
#include "ir/scalar.h"
#include "ir/walk.h"

namespace clipc::ir {
namespace {

// Whether the expression is the variable, or a conversion of the variable from one kind of integer
// to another.
bool IsCounter(const Program& program, ExprId expr, VarId counter) {
  if (const auto* convert = As<Convert>(program, expr);
      convert && IsInteger(TypeOf(program, expr).scalar) &&
      IsInteger(TypeOf(program, convert->operand).scalar))
    expr = convert->operand;
  const auto* ref = As<VarRef>(program, expr);
  if (!ref || ref->var != counter) return false;
  const Type& type = TypeOf(program, expr);
  return type.kind == TypeKind::kScalar && BaseOf(type.scalar) != Scalar::kBool;
}

bool ComparesCounter(const Program& program, ExprId expr, VarId counter) {
  const auto* compare = As<Binary>(program, expr);
  return compare && IsComparison(compare->op) && IsCounter(program, compare->left, counter);
}

void FindComparison(const Program& program, ExprId condition, CountedLoop& parts) {
  if (ComparesCounter(program, condition, parts.counter)) {
    parts.comparison = condition;
    return;
  }
  const auto* both = As<Binary>(program, condition);
  const bool is_and =
      both && (both->op == BinaryOp::kLogicalAnd || both->op == BinaryOp::kShortCircuitAnd);
  if (!is_and) return;
  const bool is_left = ComparesCounter(program, both->left, parts.counter);
  if (!is_left && !ComparesCounter(program, both->right, parts.counter)) return;
  parts.comparison = is_left ? both->left : both->right;
  parts.more = is_left ? both->right : both->left;
}

void FindStep(const Program& program, ExprId step, CountedLoop& parts) {
  if (const auto* unary = As<Unary>(program, step)) {
    if (!ChangesOperand(unary->op) || !IsCounter(program, unary->operand, parts.counter)) return;
    parts.step = step;
    parts.is_down = !IsIncrement(unary->op);
  } else if (const auto* assign = As<Assign>(program, step)) {
    const bool is_sum = assign->op == BinaryOp::kAdd || assign->op == BinaryOp::kSub;
    if (!is_sum || !IsCounter(program, assign->target, parts.counter)) return;
    parts.step = step;
    parts.step_size = assign->value;
    parts.is_down = assign->op == BinaryOp::kSub;
  }
}

void FindJumps(const Program& program, StmtId stmt, bool in_switch, LoopJumps& jumps) {
  if (As<Break>(program, stmt) && !in_switch) jumps.breaks.push_back(stmt);
  if (As<Continue>(program, stmt)) jumps.continues.push_back(stmt);
  if (As<For>(program, stmt) || As<While>(program, stmt) || As<DoWhile>(program, stmt)) return;
  const bool is_switch = As<Switch>(program, stmt) != nullptr;
  ForEachPart(
      program, stmt, [](ExprId) {},
      [&](StmtId part) { FindJumps(program, part, in_switch || is_switch, jumps); });
}

}  // namespace

CountedLoop PartsOf(const Program& program, const For& loop) {
  CountedLoop parts;
  for (const StmtId stmt : program.stmt_lists[loop.init]) {
    CountedLoop found;
    if (const auto* declare = As<Declare>(program, stmt)) {
      found = {.counter = declare->var, .is_declared = true, .start = declare->init};
    } else if (const Assign* assign = AsAssignment(program, stmt)) {
      if (const auto* target = As<VarRef>(program, assign->target))
        found = {.counter = target->var, .start = assign->value};
    }
    if (!found.counter) return {};
    FindComparison(program, loop.condition, found);
    if (!parts.counter || (!parts.comparison && found.comparison)) parts = found;
  }
  if (parts.counter) FindStep(program, loop.step, parts);
  return parts;
}

bool IsChangedInBody(const Program& program, const For& loop, VarId counter) {
  return AssignedIn(program, std::span(&loop.body, 1))[counter.index];
}

LoopJumps JumpsOf(const Program& program, StmtId body) {
  LoopJumps jumps;
  FindJumps(program, body, false, jumps);
  return jumps;
}

}  // namespace clipc::ir
