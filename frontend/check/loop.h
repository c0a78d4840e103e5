// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Loops.
namespace clipc::check {

void CheckNode(Context& context, const ast::ForStmt& stmt, Span span);
// Declares the variable of a finished `for` at the top of the function, because it is used after
// the loop.
void HoistLoopVariable(Context& context, SymbolId id);
void CheckNode(Context& context, const ast::WhileStmt& stmt, Span span);
void CheckNode(Context& context, const ast::DoStmt& stmt, Span span);
// Reports a checked loop that never ends (fxc X3696, dxc's FLOW.DEADLOOP), `[unroll(n)]` aside, and
// up to shader model 5.1 one without a hint that runs at most once (fxc X3557).
void CheckIterations(Context& context, StmtId loop, Span span, Hint hint);

}  // namespace clipc::check
