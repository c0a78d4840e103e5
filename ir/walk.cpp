// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/walk.h"

namespace clipc::ir {

Slots SlotsOf(const Expr& expr) {
  Slots slots;
  Visit(
      [&](const auto& node) {
        ForEachSlot(
            node, [&](ExprId operand) { slots.own[slots.own_count++] = operand; },
            [&](List<ExprId> list) { slots.list = list; });
      },
      expr.node);
  return slots;
}

}  // namespace clipc::ir
