// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "base/overloaded.h"
#include "ir/program.h"

// The children of a node, each kind of node once: whoever walks the tree need not know all kinds.
namespace clipc::ir {

// Calls own(ExprId&) for each operand that `expr` holds itself, or list(List<ExprId>) for a list of
// them, in the order of evaluation.
template <typename Own, typename Listed>
void ForEachSlot(Expr& expr, Own&& own, Listed&& list) {
  Visit(Overloaded{
            [](Literal&) {},
            [](Zero&) {},
            [](VarRef&) {},
            [&](FieldRef& node) { own(node.base); },
            [&](Index& node) { own(node.base), own(node.index); },
            [&](Swizzle& node) { own(node.base); },
            [&](MatrixSwizzle& node) { own(node.base); },
            [&](Unary& node) { own(node.operand); },
            [&](Binary& node) { own(node.left), own(node.right); },
            [&](Assign& node) { own(node.target), own(node.value); },
            [&](Conditional& node) {
              own(node.condition), own(node.when_true), own(node.when_false);
            },
            [&](Select& node) { own(node.condition), own(node.when_true), own(node.when_false); },
            [&](Convert& node) { own(node.operand); },
            [&](Splat& node) { own(node.operand); },
            [&](Construct& node) { list(node.arguments); },
            [&](MatrixTruncate& node) { own(node.operand); },
            [&](Call& node) { list(node.arguments); },
            [&](IntrinsicCall& node) { list(node.arguments); },
            [&](ObjectCall& node) { list(node.arguments); },
            [&](Comma& node) { own(node.first), own(node.second); },
        },
        expr.node);
}

// Calls visit(ExprId) for the direct operands of `expr` in the order of evaluation. `visit` may add
// nodes; to replace operands there is MapOperands.
template <typename OnOperand>
void ForEachOperand(const Program& program, ExprId expr, OnOperand&& visit) {
  ForEachSlot(
      const_cast<Expr&>(program.exprs[expr]),  // only read
      [&](ExprId operand) { visit(operand); },
      [&](List<ExprId> list) {
        for (std::uint32_t i = 0; i < list.size; ++i) visit(program.expr_lists[list][i]);
      });
}

// Replaces each direct operand of `expr` by map(operand), in the order of evaluation.
template <typename Map>
void MapOperands(Program& program, ExprId expr, Map&& map) {
  ForEachSlot(
      program.exprs[expr], [&](ExprId& operand) { operand = map(operand); },
      [&](List<ExprId> list) {
        for (std::uint32_t i = 0; i < list.size; ++i) {
          const ExprId mapped = map(program.expr_lists[list][i]);
          program.expr_lists[list][i] = mapped;
        }
      });
}

// Calls on_expr(ExprId) for the expressions and on_stmt(StmtId) for the statements directly in
// `stmt`, in the order of the text. Absent ones (an If without else, a For without step) are not
// visited.
template <typename OnExpr, typename OnStmt>
void ForEachPart(const Program& program, StmtId stmt, OnExpr&& on_expr, OnStmt&& on_stmt) {
  const auto expr = [&](ExprId id) {
    if (id) on_expr(id);
  };
  const auto list = [&](List<StmtId> stmts) {
    for (std::uint32_t i = 0; i < stmts.size; ++i) on_stmt(program.stmt_lists[stmts][i]);
  };
  Visit(Overloaded{
            [&](const Block& node) { list(node.body); },
            [&](const Declare& node) { expr(node.init); },
            [&](const Evaluate& node) { expr(node.expr); },
            [&](const If& node) {
              expr(node.condition);
              on_stmt(node.then);
              if (node.otherwise) on_stmt(node.otherwise);
            },
            [&](const For& node) {
              list(node.init);
              expr(node.condition), expr(node.step);
              on_stmt(node.body);
            },
            [&](const While& node) { expr(node.condition), on_stmt(node.body); },
            [&](const DoWhile& node) { on_stmt(node.body), expr(node.condition); },
            [&](const Switch& node) {
              expr(node.value);
              for (std::uint32_t i = 0; i < node.cases.size; ++i) {
                const SwitchCase arm = program.switch_cases[node.cases][i];
                for (std::uint32_t l = 0; l < arm.labels.size; ++l)
                  expr(program.expr_lists[arm.labels][l]);
                list(arm.body);
              }
            },
            [&](const Return& node) { expr(node.value); },
            [](const Break&) {},
            [](const Continue&) {},
        },
        program.stmts[stmt].node);
}

}  // namespace clipc::ir
