// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Expressions. Each is checked bottom up into a typed expression of the program. After an error it
// has the error type, which silences errors that follow from it.
namespace clipc::check {

ExprId CheckExpr(Context& context, ast::ExprId id);
// The value that a name stands for.
ExprId UseSymbol(Context& context, SymbolId id, Span span);

}  // namespace clipc::check
