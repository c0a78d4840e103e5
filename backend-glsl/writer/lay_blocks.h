// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "backend-glsl/writer/context.h"

namespace clipc::glsl {

// Names all that the constant buffers that are reached declare, and binds them. Returns them in the
// order of their declarations.
std::vector<GlslInfo::UniformBlock> LayBlocks(WriterContext& context);

}  // namespace clipc::glsl
