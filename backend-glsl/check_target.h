// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

#include "backend-glsl/style.h"
#include "backend-glsl/target.h"
#include "base/diagnostics.h"
#include "ir/program.h"
#include "legalize/es100/long_loop.h"

namespace clipc::glsl {

// Reports everything that `main` reaches and the target cannot say. Without errors, WriteGlsl
// succeeds. Requires that the clip planes are lowered: which of them become clip distances is
// decided there. `long_loops` are what UnrollLoops returned.
void CheckTarget(const ir::Program& program, const Target& target, BlockStyle blocks,
                 std::span<const legalize::LongLoop> long_loops, Diagnostics& diagnostics);

}  // namespace clipc::glsl
