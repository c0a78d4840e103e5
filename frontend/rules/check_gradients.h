// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/names.h"

namespace clipc::rules {

// Warns of derivatives, and of samples whose level of detail comes from the neighbouring pixels, in
// flow that the neighbours may not share: GLSL leaves their values undefined. fxc moves them before
// a branch, with X4121, and unrolls a loop, with X3570, or refuses it, X4014.
//
// A `?:` is a branch from 6.0 on. Flow varies where a condition follows from an input that is
// interpolated or from an atomic operation, and after a `return` in such flow. Flat inputs, the
// front face and the like are the same for the pixels of a quad. What follows from these alone has
// no differences, in any flow. Requires a program without errors; needs time linear in it.
void CheckGradients(const Program& program, Diagnostics& diagnostics);

}  // namespace clipc::rules
