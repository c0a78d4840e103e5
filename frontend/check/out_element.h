// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Elements of writable buffers and textures as arguments that a function of HLSL's own, or a method
// of an object, writes: `InterlockedAdd(o[0], 1, o[1])`, `sincos(x, s, f[15])`.
namespace clipc::check {

// What is evaluated around such a call.
struct OutElements {
  Exprs before, after;
};
// Turns the elements that the call writes into variables, which `after` stores into the objects.
// If an argument has side effects, all are evaluated in `before`, from left to right: DXC's
// CodeGenFunction::EmitCallArgs, where an `out` argument is the place that it names.
OutElements TakeOutElements(Context& context, std::string_view name, Exprs& arguments);
// The call with what comes before and after it; its value is the call's.
ExprId WithOutElements(Context& context, OutElements elements, ExprId call);

// Evaluates the value of an argument, or what chooses the place that it is, before what follows.
ExprId EvaluateNow(Context& context, ExprId argument, bool is_place, Exprs& before);

}  // namespace clipc::check
