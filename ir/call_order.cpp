// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/call_order.h"

namespace clipc::ir {

KeptVector<FunctionId> CalleesFirst(const Program& program) {
  std::size_t calls = 0;
  program.exprs.ForEach(
      [&](ExprId, const Expr& expr) { calls += std::holds_alternative<Call>(expr.node); });
  return CalleesFirst(program, [](ExprId, const Expr&) {}, [](FunctionId) { return true; }, calls);
}

}  // namespace clipc::ir
