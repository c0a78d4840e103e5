// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string_view>

namespace clipc {

// Exit codes of the program.
inline constexpr int kExitOk = 0;
inline constexpr int kExitErrors = 1;  // the shader has errors
// The command line is wrong, or a file cannot be read or written.
inline constexpr int kExitUsage = 2;

// Runs the clipc program, which was built from `commit`; empty if that is not known. `arguments` do
// not include the name of the program. Returns the exit code.
int RunCommandLine(std::span<const char* const> arguments, std::string_view commit = {});

}  // namespace clipc
