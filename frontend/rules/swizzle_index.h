// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/rules.h"

namespace clipc::rules {

// Makes v.zyx[i], an index into a swizzle, v[int3(2, 1, 0)[i]], which can be assigned to. Any other
// expression stays as it is.
void IndexWholeVector(Program& program, ExprId target);

}  // namespace clipc::rules
