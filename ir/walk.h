// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>

#include "base/overloaded.h"
#include "ir/program.h"

// The children of a node, each kind of node once: whoever walks the tree need not know all kinds.
namespace clipc::ir {

// Where an expression keeps its operands: up to three in the node itself, or a list.
struct OperandSlots {
  std::array<ExprId*, 3> own{};
  std::size_t own_count = 0;
  List<ExprId> list;
};
OperandSlots SlotsOf(Expr& expr);

// Calls visit(ExprId) for the direct operands of `expr` in the order of evaluation. `visit` may add
// nodes; to replace operands there is MapOperands.
template <typename Visit>
void ForEachOperand(const Program& program, ExprId expr, Visit&& visit) {
  // The slots of a const node are only read.
  const OperandSlots slots = SlotsOf(const_cast<Expr&>(program.exprs[expr]));
  for (std::size_t i = 0; i < slots.own_count; ++i) visit(*slots.own[i]);
  for (std::uint32_t i = 0; i < slots.list.size; ++i) visit(program.expr_lists[slots.list][i]);
}

// Replaces each direct operand of `expr` by map(operand), in the order of evaluation.
template <typename Map>
void MapOperands(Program& program, ExprId expr, Map&& map) {
  const OperandSlots slots = SlotsOf(program.exprs[expr]);
  for (std::size_t i = 0; i < slots.own_count; ++i) *slots.own[i] = map(*slots.own[i]);
  for (std::uint32_t i = 0; i < slots.list.size; ++i) {
    const ExprId mapped = map(program.expr_lists[slots.list][i]);
    program.expr_lists[slots.list][i] = mapped;
  }
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
  std::visit(Overloaded{
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
