// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/random/program.h"

namespace clipc::random {

// A program of loops in many forms, whose iterations are known at compile time, for the targets
// that unroll them: it has nothing that GLSL ES 1.00 lacks otherwise, and is drawn as that.
Program MakeLoops(Choices& choices, const Features& features);

}  // namespace clipc::random
