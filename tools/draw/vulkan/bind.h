// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-glsl/write.h"
#include "ir/program.h"
#include "tools/draw/vulkan/run.h"

namespace clipc::draw::vulkan {

// A draw call with `inputs` at the locations, sets and bindings that `info` has.
DrawCall MakeDrawCall(const ir::Program& program, const GlslInfo& info, const Inputs& inputs);

}  // namespace clipc::draw::vulkan
