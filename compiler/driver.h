// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

namespace clipc {

// Exit codes of the program.
inline constexpr int kExitOk = 0;
inline constexpr int kExitErrors = 1;  // the shader has errors
inline constexpr int kExitUsage =
    2;  // the command line is wrong, or a file cannot be read or written

// The clipc program, given its arguments without its own name.
int RunCommandLine(std::span<const char* const> arguments);

}  // namespace clipc
