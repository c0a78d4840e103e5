// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/unroll.h"

#include <cstdint>

#include "frontend/check/value.h"
#include "frontend/rules/loop_iterations.h"

namespace clipc::check {

void LimitIterations(Context& context, const ast::Attr& unroll) {
  constexpr std::int64_t kMost = 65536;  // fxc unrolls no loop as often
  const auto* literal = context.GetIf<ast::Literal>(context[unroll.arguments][0]);
  if (literal && literal->kind != LiteralKind::kInt && literal->kind != LiteralKind::kUint) {
    context.Report(unroll.span, diag::AttributeArgument, "unroll");
    return;
  }
  const auto limit = ConstantInteger(context, context[unroll.arguments][0]);
  if (!limit || *limit < 1 || *limit > kMost) return;
  Program& program = context.program;
  const StmtId id = context.stmts.back();
  const auto* counted = As<For>(program, id);
  if (counted && rules::EndsWithin(program, *counted, *limit).value_or(false)) return;
  Builder at = context.At(unroll.span);
  const TypeId integer = program.types.Make(Scalar::kInt);
  const VarId iterations = at.Local("iterations", integer);
  context.stmts.insert(context.stmts.end() - 1, at.Stmt(Declare{iterations, at.Int(0)}));
  const auto limited = [&](ExprId count, ExprId condition) {
    const ExprId may =
        at.BinaryOf(BinaryOp::kLess, count, at.Int(static_cast<std::int32_t>(*limit)));
    return condition ? at.BinaryOf(BinaryOp::kShortCircuitAnd, may, condition) : may;
  };
  const ExprId next = at.Add(integer, Unary{UnaryOp::kPreIncrement, at.Ref(iterations)});
  if (const auto* loop = As<DoWhile>(program, id)) {
    const DoWhile node = *loop;
    program.stmts[id].node = DoWhile{node.body, limited(next, node.condition)};
  } else if (const auto* loop = As<While>(program, id)) {
    const While node = *loop;
    program.stmts[id].node = For{{}, limited(at.Ref(iterations), node.condition), next, node.body};
  } else if (counted) {
    For node = *counted;
    node.condition = limited(at.Ref(iterations), node.condition);
    node.step = node.step ? at.CommaOf(node.step, next) : next;
    program.stmts[id].node = node;
  }
}

}  // namespace clipc::check
