// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// Removes outputs that nothing writes and that a pipeline does without: the layer, the viewport and
// the shading rate, which struct types may bring along. A target that lacks them can then express
// the shader.
//
// Requires and ensures Form::kInlined.
void DropUnwritten(ir::Program& program);

}  // namespace clipc::passes
