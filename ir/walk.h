// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "base/overloaded.h"
#include "ir/program.h"

// The children of a node, with one place for each kind of node: code that walks the tree need not
// know all kinds.
namespace clipc::ir {

// A node that is of one of these kinds, const or not.
template <typename Node, typename... Kinds>
concept OneOf = (std::same_as<std::remove_const_t<Node>, Kinds> || ...);

// Calls own(operand) for each operand that a node, an alternative of Expr::node, holds itself, a
// reference to an ExprId that is as const as the node, or list(List<ExprId>) for a list of them, in
// the order of evaluation.
template <typename Node, typename Own, typename Listed>
void ForEachSlot(Node& node, Own&& own, Listed&& list) {
  Overloaded{
      [](OneOf<Literal, Zero, VarRef> auto&) {},
      [&](OneOf<FieldRef, Swizzle, MatrixSwizzle> auto& of) { own(of.base); },
      [&](OneOf<Index> auto& of) { own(of.base), own(of.index); },
      [&](OneOf<Unary, Convert, Splat, MatrixTruncate> auto& of) { own(of.operand); },
      [&](OneOf<Binary> auto& of) { own(of.left), own(of.right); },
      [&](OneOf<Assign> auto& of) { own(of.target), own(of.value); },
      [&](OneOf<Conditional, Select> auto& of) {
        own(of.condition), own(of.when_true), own(of.when_false);
      },
      [&](OneOf<Construct, Call, IntrinsicCall> auto& of) { list(of.arguments); },
      [&](OneOf<ObjectCall> auto& of) { list(of.Operands()); },
      [&](OneOf<Comma> auto& of) { own(of.first), own(of.second); },
  }(node);
}

// The operands of a node in the order of evaluation: those that it holds itself, or a list.
struct Slots {
  std::array<ExprId, 3> own;
  std::uint32_t own_count = 0;
  List<ExprId> list;
};
Slots SlotsOf(const Expr& expr);

// Calls visit(ExprId) for the direct operands of `expr` in the order of evaluation. `visit` may
// change the node: a copy of its operands is walked. MapOperands replaces operands.
template <typename OnOperand>
void ForEachOperand(const Program& program, ExprId expr, OnOperand&& visit) {
  const auto& node = program.exprs[expr].node;
  // Half of all expressions. One function tells the others apart for all walks, so that these stay
  // small.
  if (std::holds_alternative<Literal>(node) || std::holds_alternative<VarRef>(node)) return;
  const Slots slots = SlotsOf(program.exprs[expr]);
  for (std::uint32_t i = 0; i < slots.own_count; ++i) visit(slots.own[i]);
  for (std::uint32_t i = 0; i < slots.list.size; ++i) visit(program.expr_lists[slots.list][i]);
}

// Replaces each direct operand of `expr` by map(operand), in the order of evaluation. `map` may
// change the node: a copy of it is changed and put back.
template <typename Map>
void MapOperands(Program& program, ExprId expr, Map&& map) {
  auto changed = program.exprs[expr].node;
  Visit(
      [&](auto& node) {
        ForEachSlot(
            node, [&](ExprId& operand) { operand = map(operand); },
            [&](List<ExprId> list) {
              for (std::uint32_t i = 0; i < list.size; ++i) {
                const ExprId mapped = map(program.expr_lists[list][i]);
                program.expr_lists[list][i] = mapped;
              }
            });
      },
      changed);
  program.exprs[expr].node = changed;
}

// Calls expr(ExprId) and part(StmtId) for the expressions and statements that `stmt` holds itself,
// references that are as const as `stmt`, list(List<StmtId>) for its lists of statements and
// cases(List<SwitchCase>) for those of a Switch, in the order of the text. Absent expressions and
// statements (an If without else, a For without step) are not visited.
template <OneOf<Stmt> MaybeConst, typename OnExpr, typename OnPart, typename OnList,
          typename OnCases>
void ForEachPartSlot(MaybeConst& stmt, OnExpr&& on_expr, OnPart&& on_part, OnList&& list,
                     OnCases&& cases) {
  const auto expr = [&](auto& id) {
    if (id) on_expr(id);
  };
  const auto part = [&](auto& id) {
    if (id) on_part(id);
  };
  Visit(Overloaded{
            [&](OneOf<Block> auto& node) { list(node.body); },
            [&](OneOf<Declare> auto& node) { expr(node.init); },
            [&](OneOf<Evaluate> auto& node) { expr(node.expr); },
            [&](OneOf<If> auto& node) {
              expr(node.condition), part(node.then), part(node.otherwise);
            },
            [&](OneOf<For> auto& node) {
              list(node.init), expr(node.condition), expr(node.step), part(node.body);
            },
            [&](OneOf<While> auto& node) { expr(node.condition), part(node.body); },
            [&](OneOf<DoWhile> auto& node) { part(node.body), expr(node.condition); },
            [&](OneOf<Switch> auto& node) { expr(node.value), cases(node.cases); },
            [&](OneOf<Return> auto& node) { expr(node.value); },
            [](OneOf<Break, Continue, Discard> auto&) {},
        },
        stmt.node);
}

// Calls on_expr(ExprId) for the expressions and on_stmt(StmtId) for the statements directly in
// `stmt`, in the order of the text. Absent ones are not visited.
template <typename OnExpr, typename OnStmt>
void ForEachPart(const Program& program, StmtId stmt, OnExpr&& on_expr, OnStmt&& on_stmt) {
  const auto list = [&](List<StmtId> stmts) {
    for (std::uint32_t i = 0; i < stmts.size; ++i) on_stmt(program.stmt_lists[stmts][i]);
  };
  ForEachPartSlot(program.stmts[stmt], on_expr, on_stmt, list, [&](List<SwitchCase> cases) {
    for (std::uint32_t i = 0; i < cases.size; ++i) {
      const SwitchCase arm = program.switch_cases[cases][i];
      for (std::uint32_t l = 0; l < arm.labels.size; ++l)
        on_expr(program.expr_lists[arm.labels][l]);
      list(arm.body);
    }
  });
}

// Calls visit(StmtId) for `stmt` and every statement in it, outer ones first.
template <typename OnStmt>
void ForEachStmt(const Program& program, StmtId stmt, OnStmt&& visit) {
  visit(stmt);
  ForEachPart(
      program, stmt, [](ExprId) {}, [&](StmtId part) { ForEachStmt(program, part, visit); });
}

// Whether holds(ExprId) is true for any expression at or below `expr`, or anywhere in `stmt`:
// parents are asked before their operands, in the order of the text, until one holds.
template <typename Holds>
bool AnyExpr(const Program& program, ExprId expr, Holds&& holds) {
  bool any = holds(expr);
  if (!any) {
    ForEachOperand(program, expr,
                   [&](ExprId operand) { any = any || AnyExpr(program, operand, holds); });
  }
  return any;
}
template <typename Holds>
bool AnyExpr(const Program& program, StmtId stmt, Holds&& holds) {
  bool any = false;
  ForEachPart(
      program, stmt, [&](ExprId expr) { any = any || AnyExpr(program, expr, holds); },
      [&](StmtId part) { any = any || AnyExpr(program, part, holds); });
  return any;
}

// Calls visit(ExprId) for every expression at and below `root`, an expression or a statement, in
// the same order.
template <typename OnExpr>
void ForEachExpr(const Program& program, ExprId root, OnExpr&& visit) {
  visit(root);
  ForEachOperand(program, root, [&](ExprId operand) { ForEachExpr(program, operand, visit); });
}
template <typename OnExpr>
void ForEachExpr(const Program& program, StmtId root, OnExpr&& visit) {
  ForEachPart(
      program, root, [&](ExprId expr) { ForEachExpr(program, expr, visit); },
      [&](StmtId part) { ForEachExpr(program, part, visit); });
}

// Whether there is an expression, or a statement, of one of these kinds. Those that were replaced
// count too, since that is faster than a walk: a `no` says that a walk finds none.
template <typename... Kinds>
bool MayHaveExpr(const Program& program) {
  return program.exprs.AnyOf(
      [](const Expr& expr) { return (std::holds_alternative<Kinds>(expr.node) || ...); });
}
template <typename... Kinds>
bool MayHaveStmt(const Program& program) {
  return program.stmts.AnyOf(
      [](const Stmt& stmt) { return (std::holds_alternative<Kinds>(stmt.node) || ...); });
}
// The same for an expression whose node is a `Kind` for which holds(node) is true.
template <typename Kind, typename Holds>
bool MayHaveExpr(const Program& program, Holds&& holds) {
  return program.exprs.AnyOf([&](const Expr& expr) {
    const auto* node = std::get_if<Kind>(&expr.node);
    return node && holds(*node);
  });
}

// Calls visit(ExprId) for every expression in the bodies of functions and in the values that
// variables begin with. The arena has others too, which were replaced and may be incomplete.
template <typename OnExpr>
void ForEachLiveExpr(const Program& program, OnExpr&& visit) {
  for (const VarId id : program.vars.ids()) {
    if (program.vars[id].init) ForEachExpr(program, program.vars[id].init, visit);
  }
  for (const FunctionId id : program.functions.ids())
    ForEachExpr(program, program.functions[id].body, visit);
}

}  // namespace clipc::ir
