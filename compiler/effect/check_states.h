// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "compiler/command/command_line.h"
#include "frontend/parse/effect.h"

namespace clipc {

// Reports, and marks as wrong, what the effect's passes, samplers and blocks of states say that
// Direct3D does not know: names of states, words that are not values of theirs, variables that
// `file` does not declare, and statements without a `;`. FindPrograms does so for shaders.
void CheckStates(const ast::File& file, EffectDialect dialect, ast::Effect& effect,
                 Diagnostics& diagnostics);

}  // namespace clipc
