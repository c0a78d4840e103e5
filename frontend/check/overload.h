// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

#include "frontend/check/context.h"

// Overload resolution: a call means the overload whose arguments need the cheapest conversions
// (CostOf).
namespace clipc::check {

struct Choice {
  FunctionInfoId function;     // none if no overload fits, and after an error
  bool reported = false;       // whether an error was reported
  bool changes_shape = false;  // whether an argument is splatted or truncated
};
// The best of the overloads that are declared so far; if none of them fits, the best of the
// overloads that are declared later.
Choice ChooseOverload(Context& context, std::span<const FunctionInfoId> overloads,
                      ExprSpan arguments, Name name, Span span);
// The function for arguments whose classes are known although its parameters are interfaces, and
// arrays of a size although those have none. There is one function for each tuple of types.
FunctionInfoId ForClasses(Context& context, FunctionInfoId id, ExprSpan arguments);
// Reports that none of the overloads fits the arguments.
void ReportNoOverload(Context& context, std::span<const FunctionInfoId> overloads,
                      ExprSpan arguments, Name name, Span span);

}  // namespace clipc::check
