// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <concepts>
#include <type_traits>

#include "base/overloaded.h"
#include "frontend/parse/ast_expr.h"

// A walk of the children of an expression of the syntax tree, which names each kind of node once.
namespace clipc::ast {

template <typename Node, typename... Kinds>
concept OneOf = (std::same_as<Node, Kinds> || ...);

// Calls child(id) for each child of the node, an ExprId or a TypeId that may be none, and
// child(list) for each List<ExprId>, in the order of the text. `Node` is one of the kinds of nodes,
// or their variant.
template <typename Node, typename OnChild>
void ForEachChild(const Node& node, OnChild&& child) {
  const Overloaded visit{
      [](const OneOf<Literal, ErrorExpr> auto&) {},
      [&](const NameExpr& e) { child(e.arguments); },
      [&](const TypeExpr& e) { child(e.type); },
      [&](const OneOf<UnaryExpr, SizeofExpr> auto& e) { child(e.operand); },
      [&](const OneOf<BinaryExpr, CommaExpr, AssignExpr> auto& e) {
        child(e.left), child(e.right);
      },
      [&](const ConditionalExpr& e) {
        child(e.condition), child(e.when_true), child(e.when_false);
      },
      [&](const CallExpr& e) { child(e.callee), child(e.arguments); },
      [&](const CastExpr& e) { child(e.type), child(e.dimensions), child(e.operand); },
      [&](const IndexExpr& e) { child(e.base), child(e.index); },
      [&](const MemberExpr& e) { child(e.base), child(e.arguments); },
      [&](const InitListExpr& e) { child(e.elements); },
  };
  if constexpr (std::is_same_v<Node, decltype(Expr::node)>) {
    Visit(visit, node);
  } else {
    visit(node);
  }
}

}  // namespace clipc::ast
