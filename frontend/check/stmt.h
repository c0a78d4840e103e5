// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "frontend/check/context.h"

// Statements except loops and switch. The checked statements are added to the end of context.stmts.
namespace clipc::check {

void CheckStmts(Context& context, List<ast::StmtId> stmts);
// Checks the body of another statement, and returns it as a Block with a scope of its own.
StmtId CheckBlock(Context& context, ast::StmtId id);
void CheckStmt(Context& context, ast::StmtId id);
// A number that a statement needs; `statement` is its name in messages.
ExprId CheckScalar(Context& context, ast::ExprId id, std::string_view statement);
// A condition as a bool; `statement` is its name in messages.
ExprId CheckCondition(Context& context, ast::ExprId id, std::string_view statement);

}  // namespace clipc::check
