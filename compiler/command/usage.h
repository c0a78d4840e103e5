// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "compiler/command/command_line.h"
#include "compiler/compile/result.h"

namespace clipc {

// The first mistake in the options, whatever the inputs are.
Result<> CheckCommand(const CommandLine& command);
// That of -Vn.
Result<> CheckVariable(const CommandLine& command);
// The first mistake in what is said about the stages between a vertex and a pixel shader.
Result<> CheckMiddle(const CommandLine& command);

// The files that the command line names to be read: shaders, a manifest, response files. No output
// takes the place of one.
std::vector<std::string> FilesRead(const CommandLine& command);

// Reports the options that have no effect on the compile of single shaders.
void ReportIdle(const CommandLine& command, Diagnostics& notices);

// The warnings about the options, as the result of a compile.
CompileResult NoticesOf(const CommandLine& command);

// Reads what the request needs besides the shader, and sets what follows from the outputs that are
// wanted.
Result<> PrepareRequest(CommandLine& command);

}  // namespace clipc
