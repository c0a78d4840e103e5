// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/unroll.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "frontend/check/value.h"
#include "frontend/rules/constant.h"

namespace clipc::check {
namespace {

VarId VarOf(const Program& program, ExprId expr) {
  const auto* ref = As<VarRef>(program, expr);
  return ref ? ref->var : VarId{};
}

// The number that a turn adds to the variable; none when it is not known.
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
  // The numbers that the others hold for have no gap.
  return !Holds(op, first, bound) || !Holds(op, first + limit * step, bound);
}

// Whether the loop, of the form `for (int i = 0; i < 4; ++i)`, is seen to end within `limit` turns.
bool EndsWithin(const Program& program, const For& loop, std::int64_t limit) {
  if (loop.init.size != 1) return false;
  const auto* declare = As<Declare>(program, program.stmt_lists[loop.init][0]);
  const auto* condition = As<Binary>(program, loop.condition);
  if (!declare || !declare->init || !condition || VarOf(program, condition->left) != declare->var)
    return false;
  const auto first = EvaluateInteger(program, declare->init);
  const auto bound = EvaluateInteger(program, condition->right);
  const auto step = StepOf(program, loop.step, declare->var);
  const StmtId body[] = {loop.body};
  if (!first || !bound || !step || AssignedIn(program, body)[declare->var.index]) return false;
  // A uint goes on below 0 as a large number.
  const bool is_signed =
      BaseOf(program.types[program.vars[declare->var].type].scalar) == Scalar::kInt;
  return (is_signed || *step > 0) && Leaves(condition->op, *first, *step, *bound, limit);
}

}  // namespace

void LimitTurns(Context& context, const ast::Attr& unroll) {
  constexpr std::int64_t kMost = 65536;  // fxc unrolls no loop as often
  const auto limit = ConstantInteger(context, context[unroll.arguments][0]);
  if (!limit || *limit < 1 || *limit > kMost) return;
  Program& program = context.program;
  const StmtId id = context.stmts.back();
  const auto* counted = As<For>(program, id);
  if (counted && EndsWithin(program, *counted, *limit)) return;
  Builder at = context.At(unroll.span);
  const TypeId integer = program.types.Make(Scalar::kInt);
  const VarId turns = at.Local("turns", integer);
  context.stmts.insert(context.stmts.end() - 1, at.Stmt(Declare{turns, at.Int(0)}));
  const auto limited = [&](ExprId count, ExprId condition) {
    const ExprId may =
        at.BinaryOf(BinaryOp::kLess, count, at.Int(static_cast<std::int32_t>(*limit)));
    return condition ? at.BinaryOf(BinaryOp::kShortCircuitAnd, may, condition) : may;
  };
  const ExprId next = at.Add(integer, Unary{UnaryOp::kPreIncrement, at.Ref(turns)});
  if (const auto* loop = As<DoWhile>(program, id)) {
    const DoWhile node = *loop;
    program.stmts[id].node = DoWhile{node.body, limited(next, node.condition)};
  } else if (const auto* loop = As<While>(program, id)) {
    const While node = *loop;
    program.stmts[id].node = For{{}, limited(at.Ref(turns), node.condition), next, node.body};
  } else if (counted) {
    For node = *counted;
    node.condition = limited(at.Ref(turns), node.condition);
    node.step = node.step ? at.CommaOf(node.step, next) : next;
    program.stmts[id].node = node;
  }
}

}  // namespace clipc::check
