// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>

#include "frontend/check/context.h"

// Writing statements to the end of context.stmts.
namespace clipc::check {

// Adds the statement, after declarations of the temporaries that it needs.
void Emit(Context& context, Span span, decltype(Stmt::node) node);
// Declares the temporaries of the expressions that were checked since the last statement.
void DeclareTemporaries(Context& context);
// Moves the statements after the first `mark` of context.stmts into a list of the program.
List<StmtId> TakeStmts(Context& context, std::size_t mark);
// Adds statements that evaluate the expression for its effects. The steps of a Comma are statements
// of their own, and the assignment that makes a temporary becomes its declaration.
void EmitValue(Context& context, ExprId value);
// What is left to evaluate of a value that nobody uses: nothing of a string, which is for the
// application only.
ExprId WithoutString(const Context& context, ExprId value);
// Adds the steps of a Comma as statements and returns its last value. The value must be evaluated
// once and before the rest of its statement.
ExprId Unwrap(Context& context, ExprId value);

}  // namespace clipc::check
