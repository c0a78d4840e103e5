// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

#include "frontend/check/context.h"

// Which overload a call means: the one whose arguments need the cheapest conversions (CostOf).
namespace clipc::check {

struct Choice {
  FunctionInfoId function;  // none: nothing fits, or an error was reported
  bool reported = false;
  bool changes_shape = false;  // an argument is splatted or truncated
};
// The best of those declared so far; when none of them fits, of those declared later.
Choice ChooseOverload(Context& context, std::span<const FunctionInfoId> overloads,
                      std::span<const ir::ExprId> arguments, Name name, Span span);
void ReportNoOverload(Context& context, std::span<const FunctionInfoId> overloads,
                      std::span<const ir::ExprId> arguments, Name name, Span span);

}  // namespace clipc::check
