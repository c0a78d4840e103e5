// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "compiler/options.h"

namespace clipc {

// Runs --effect: compiles every pass of an effect as a pair or a single shader, and writes JSON
// that describes the effect beside them (docs/effects.md). Returns the exit code.
int RunEffect(CommandLine command);

}  // namespace clipc
