// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <vector>

#include "compiler/options.h"
#include "compiler/permutations.h"

// The compilation of many settings of a few shaders in one run: docs/permutations.md.
namespace clipc {

// Whether the command line asks for a batch, by a manifest or a macro with several values.
bool WantsBatch(const CommandLine& command);

// Runs a batch. `arguments` are those that `command` was read from. Returns the exit code.
int RunBatch(std::span<const char* const> arguments, CommandLine command);

}  // namespace clipc
