// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "frontend/check/context.h"

// Calls of functions, methods and built-in functions.
namespace clipc::check {

ir::ExprId CheckCall(Context& context, const ast::CallExpr& expr, Span span);
// False when an argument has an error.
bool CheckArguments(Context& context, List<ast::ExprId> list, std::vector<ir::ExprId>& arguments);
// A call with its object (for a method) and arguments, converted and with what `out` parameters
// need around it.
ir::ExprId CallFunction(Context& context, FunctionInfoId id, ir::ExprId self,
                        std::vector<ir::ExprId> arguments, Span name_span, Span span);

}  // namespace clipc::check
