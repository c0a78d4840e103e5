// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>

#include "compiler/command/command_line.h"
#include "compiler/command/run_result.h"

namespace clipc {

// Runs a command line, and again whenever a file that it read has changed: the inputs that read it,
// or a whole batch. After an error also when a file appears or disappears in a folder of includes,
// which may be the one that is missing. Ends with an interrupt, or when the first run finds the
// options wrong. Returns the exit code of the last run.
int WatchFiles(CommandLine command, const std::function<RunResult(CommandLine)>& run);

}  // namespace clipc
