// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-glsl/writer/context.h"

namespace clipc::glsl {

// Names everything but locals, which are named when they are declared. The names that the host sees
// come first and so keep their spelling.
void NameEverything(Context& context);

}  // namespace clipc::glsl
