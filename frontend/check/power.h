// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Powers with an exponent that is a known whole number.
namespace clipc::check {

// The products that fxc and dxc make of a call of `pow` with such an exponent; every other
// expression is returned as it is. pow(x, 2) of a negative x has a value in Direct3D so, and in
// GLSL and SPIR-V `pow` has none.
ExprId ExpandPower(Context& context, ExprId call);

}  // namespace clipc::check
