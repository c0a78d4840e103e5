// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-glsl/writer/context.h"

namespace clipc::glsl {

// Writes the constant buffers that are reached, as uniform blocks, or as uniform variables where
// the target has no blocks; and the functions that read the buffers that are written as rows.
void WriteBlocks(Context& context);

}  // namespace clipc::glsl
