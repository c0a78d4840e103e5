// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-glsl/writer/context.h"

namespace clipc::glsl {

// The constant buffers that are reached: uniform blocks, or uniform variables where the target has
// no blocks; and the functions that read those that are written as rows.
void WriteBlocks(Context& context);

}  // namespace clipc::glsl
