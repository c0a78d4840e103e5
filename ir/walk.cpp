// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/walk.h"

namespace clipc::ir {
namespace {

template <typename... Ids>
OperandSlots Own(Ids&... ids) {
  return {.own = {&ids...}, .own_count = sizeof...(ids), .list = {}};
}
OperandSlots Listed(List<ExprId> list) { return {.own = {}, .own_count = 0, .list = list}; }

}  // namespace

OperandSlots SlotsOf(Expr& expr) {
  return std::visit(
      Overloaded{
          [](Literal&) { return Own(); },
          [](Zero&) { return Own(); },
          [](VarRef&) { return Own(); },
          [](FieldRef& node) { return Own(node.base); },
          [](Index& node) { return Own(node.base, node.index); },
          [](Swizzle& node) { return Own(node.base); },
          [](MatrixSwizzle& node) { return Own(node.base); },
          [](Unary& node) { return Own(node.operand); },
          [](Binary& node) { return Own(node.left, node.right); },
          [](Assign& node) { return Own(node.target, node.value); },
          [](Conditional& node) { return Own(node.condition, node.when_true, node.when_false); },
          [](Select& node) { return Own(node.condition, node.when_true, node.when_false); },
          [](Convert& node) { return Own(node.operand); },
          [](Splat& node) { return Own(node.operand); },
          [](Construct& node) { return Listed(node.arguments); },
          [](MatrixTruncate& node) { return Own(node.operand); },
          [](Call& node) { return Listed(node.arguments); },
          [](IntrinsicCall& node) { return Listed(node.arguments); },
          [](ObjectCall& node) { return Listed(node.arguments); },
          [](Comma& node) { return Own(node.first, node.second); },
      },
      expr.node);
}

}  // namespace clipc::ir
