// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/rules.h"

// Values of a pixel shader's inputs that GLSL has in another form.
namespace clipc::rules {

// The position of a sample with the x and y of the center of its pixel.
ExprId CenterOf(Program& program, ExprId position);
// Whether the first bit of `coverage` is set, which `bool c : SV_Coverage` is in fxc's code: it
// masks the coverage with 1.
ExprId FirstBitOf(Program& program, ExprId coverage);

}  // namespace clipc::rules
