// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// The ends of functions that have a result.
namespace clipc::check {

// Reports a function that may reach its end without a `return` (X3507). One that has a `return` and
// parameters waits for JudgeEnds up to profile 5.1.
void CheckEnd(Context& context, FunctionId function, Span name);

// Judges the functions that wait by their calls, as fxc does, which knows the constants of a call
// (Source SDK 2013 ships `float3 Fog(float3 c, const int kind) { if (kind == 0) return c * 0.5;
// else if (kind == 1) return c; }`, called with 0 and 1; dxc refuses it). A call that reaches the
// end for sure is an error, and so is one without constants that may reach it; another that may is
// a warning. The result is 0 at such an end. Requires `main`.
void JudgeEnds(Context& context);

}  // namespace clipc::check
