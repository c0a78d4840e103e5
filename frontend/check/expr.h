// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Expressions. Each is checked bottom up into a typed expression of the program; after an error it
// has the error type, which silences what follows.
namespace clipc::check {

ir::ExprId CheckExpr(Context& context, ast::ExprId id);
ir::ExprId UseSymbol(Context& context, SymbolId id, Span span);

}  // namespace clipc::check
