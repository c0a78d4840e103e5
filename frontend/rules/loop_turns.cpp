// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/loop_turns.h"

#include <span>

#include "frontend/rules/constant.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

VarId VarOf(const Program& program, ExprId expr) {
  const auto* ref = As<VarRef>(program, expr);
  return ref ? ref->var : VarId{};
}

// The number that a turn adds to the counter; nullopt if it is not known.
std::optional<std::int64_t> StepOf(const Program& program, ExprId step, VarId counter) {
  if (const auto* unary = As<Unary>(program, step);
      unary && VarOf(program, unary->operand) == counter) {
    using enum UnaryOp;
    if (unary->op == kPreIncrement || unary->op == kPostIncrement) return 1;
    if (unary->op == kPreDecrement || unary->op == kPostDecrement) return -1;
  }
  const auto* assign = As<Assign>(program, step);
  if (!assign || VarOf(program, assign->target) != counter) return std::nullopt;
  const auto by = EvaluateInteger(program, assign->value);
  if (!by || (assign->op != BinaryOp::kAdd && assign->op != BinaryOp::kSub)) return std::nullopt;
  return assign->op == BinaryOp::kAdd ? *by : -*by;
}

bool Holds(BinaryOp op, std::int64_t left, std::int64_t right) {
  switch (op) {
    case BinaryOp::kLess: return left < right;
    case BinaryOp::kLessEqual: return left <= right;
    case BinaryOp::kGreater: return left > right;
    case BinaryOp::kGreaterEqual: return left >= right;
    default: return true;
  }
}

// Whether `first`, `first + step`, ... leaves the condition within `limit` steps.
bool Leaves(BinaryOp op, std::int64_t first, std::int64_t step, std::int64_t bound,
            std::int64_t limit) {
  if (op == BinaryOp::kNotEqual)
    return first == bound || (step != 0 && (bound - first) % step == 0 &&
                              (bound - first) / step > 0 && (bound - first) / step <= limit);
  // The numbers that the other operators hold for have no gap.
  return !Holds(op, first, bound) || !Holds(op, first + limit * step, bound);
}

// Whether a comparison by the operator may end a count.
bool MayBound(BinaryOp op) {
  return op == BinaryOp::kLess || op == BinaryOp::kLessEqual || op == BinaryOp::kGreater ||
         op == BinaryOp::kGreaterEqual || op == BinaryOp::kNotEqual;
}

// Whether the body may end the loop before its condition does.
bool MayEnd(const Program& program, StmtId body) {
  bool may_end = false;
  ForEachStmt(program, body, [&](StmtId stmt) {
    may_end |= As<Break>(program, stmt) != nullptr || As<Return>(program, stmt) != nullptr;
  });
  return may_end;
}

}  // namespace

VarId CounterOf(const Program& program, const For& loop) {
  if (loop.init.size != 1) return {};
  const auto* declare = As<Declare>(program, program.stmt_lists[loop.init][0]);
  const auto* condition = As<Binary>(program, loop.condition);
  if (!declare || !declare->init || !condition || !MayBound(condition->op)) return {};
  return VarOf(program, condition->left) == declare->var ? declare->var : VarId{};
}

std::optional<bool> EndsWithin(const Program& program, const For& loop, std::int64_t limit) {
  const VarId counter = CounterOf(program, loop);
  if (!counter) return std::nullopt;
  const auto& condition = *As<Binary>(program, loop.condition);
  const auto& declare = *As<Declare>(program, program.stmt_lists[loop.init][0]);
  const auto first = EvaluateInteger(program, declare.init);
  const auto bound = EvaluateInteger(program, condition.right);
  const auto step = StepOf(program, loop.step, counter);
  if (!first || !bound || !step) return std::nullopt;
  // A uint goes on below 0 as a large number.
  const bool is_signed = BaseOf(program.types[program.vars[counter].type].scalar) == Scalar::kInt;
  if (!is_signed && *step < 0) return std::nullopt;
  if (AssignedIn(program, std::span(&loop.body, 1))[counter.index]) return std::nullopt;
  if (Leaves(condition.op, *first, *step, *bound, limit)) return true;
  return MayEnd(program, loop.body) ? std::nullopt : std::optional(false);
}

}  // namespace clipc::rules
