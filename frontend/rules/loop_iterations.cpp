// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/loop_iterations.h"

#include "frontend/typing/constant.h"
#include "ir/access.h"
#include "ir/counted_loop.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

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

// A count from one known number to another, by a known step.
struct KnownCount {
  VarId counter;
  BinaryOp op;
  std::int64_t first, step, bound;
};

std::optional<KnownCount> KnownCountOf(const Program& program, const For& loop) {
  const CountedLoop count = PartsOf(program, loop);
  const auto* compare = As<Binary>(program, count.comparison);
  const bool is_plain = compare && As<VarRef>(program, compare->left) && !count.more &&
                        loop.init.size == 1 && count.start && count.step &&
                        program.vars[count.counter].storage == Storage::kLocal;
  if (!is_plain || !MayBound(compare->op)) return std::nullopt;
  const auto first = EvaluateInteger(program, count.start);
  const auto bound = EvaluateInteger(program, compare->right);
  const auto size = count.step_size ? EvaluateInteger(program, count.step_size) : 1;
  if (!first || !bound || !size) return std::nullopt;
  const std::int64_t step = count.is_down ? -*size : *size;
  // A uint goes on below 0 as a large number.
  const bool is_signed =
      BaseOf(program.types[program.vars[count.counter].type].scalar) == Scalar::kInt;
  if (!is_signed && step < 0) return std::nullopt;
  return KnownCount{count.counter, compare->op, *first, step, *bound};
}

bool LeavesWithin(const KnownCount& count, std::int64_t limit) {
  return Leaves(count.op, count.first, count.step, count.bound, limit);
}

}  // namespace

bool NeverLeaves(const Program& program, const For& loop) {
  const CountedLoop count = PartsOf(program, loop);
  const auto* compare = As<Binary>(program, count.comparison);
  const bool is_plain = compare && As<VarRef>(program, compare->left) && !count.more;
  if (!is_plain || !MayBound(compare->op)) return false;
  const auto bound = EvaluateInteger(program, compare->right);
  if (IsUnsigned(TypeOf(program, compare->left).scalar) && compare->op == BinaryOp::kGreaterEqual)
    return bound == 0;
  const auto first = count.start ? EvaluateInteger(program, count.start) : std::nullopt;
  return first && bound && !loop.step && !IsChangedInBody(program, loop, count.counter) &&
         !Leaves(compare->op, *first, 0, *bound, 1);
}

std::optional<bool> EndsWithin(const Program& program, const For& loop, std::int64_t limit) {
  const auto count = KnownCountOf(program, loop);
  if (!count || IsChangedInBody(program, loop, count->counter)) return std::nullopt;
  if (LeavesWithin(*count, limit)) return true;
  return MayEnd(program, loop.body) ? std::nullopt : std::optional(false);
}

bool RunsAtMostOnce(const Program& program, const For& loop) {
  const auto count = KnownCountOf(program, loop);
  return count && LeavesWithin(*count, 1) && !IsChangedInBody(program, loop, count->counter);
}

}  // namespace clipc::rules
