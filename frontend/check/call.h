// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Calls of functions, methods and built-in functions.
namespace clipc::check {

ExprId CheckNode(Context& context, const ast::CallExpr& expr, Span span);
// Appends the checked arguments. Returns false if one of them has an error.
bool CheckArguments(Context& context, List<ast::ExprId> list, Exprs& arguments);
// A call of the function with its object (`self`, of a method) and arguments: the arguments are
// converted, and arguments of `out` parameters copied back where needed.
ExprId CallFunction(Context& context, FunctionInfoId id, ExprId self, Exprs arguments,
                    const UseSpans& spans);

}  // namespace clipc::check
