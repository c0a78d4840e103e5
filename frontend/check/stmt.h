// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "frontend/check/context.h"

// Statements but for loops and switch. What is checked is put at the end of stmts_.
namespace clipc::check {

void CheckStmts(Context& context, List<ast::StmtId> stmts);
// A statement that is the body of another, always a Block, with a scope of its own.
ir::StmtId CheckBlock(Context& context, ast::StmtId id);
void CheckStmt(Context& context, ast::StmtId id);
ir::ExprId CheckCondition(Context& context, ast::ExprId id, std::string_view statement);

}  // namespace clipc::check
