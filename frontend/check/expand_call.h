// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Calls of intrinsic functions that mean something else in GLSL and SPIR-V where an argument is
// known.
namespace clipc::check {

// What fxc and dxc make of the call of `clamp` or `pow`; every other expression is returned as it
// is.
ExprId ExpandCall(Context& context, ExprId call);

}  // namespace clipc::check
