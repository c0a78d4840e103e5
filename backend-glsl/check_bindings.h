// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-glsl/reach.h"
#include "backend-glsl/target.h"
#include "base/diagnostics.h"
#include "ir/program.h"

namespace clipc::glsl {

// Reports the bindings of a Vulkan target that are too high or taken: registers of all kinds share
// the bindings of a set.
void CheckBindings(const ir::Program& program, const Reached& reached, const Target& target,
                   Diagnostics& diagnostics);

}  // namespace clipc::glsl
