// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// clamp() whose bounds are known and the wrong way round.
namespace clipc::check {

// The min(max(x, low), high) that such a call is; every other expression is returned as it is.
// GLSL and SPIR-V leave a lower bound above the upper one undefined, and HLSL does not
// ("clamp" among the intrinsic functions of Microsoft's reference; TranslateClamp in DXC's
// HLOperationLower.cpp).
ExprId ExpandClamp(Context& context, ExprId call);

}  // namespace clipc::check
