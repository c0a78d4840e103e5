// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace clipc {

// Exit codes of the program.
inline constexpr int kExitOk = 0;
inline constexpr int kExitErrors = 1;  // the shader has errors
// The command line is wrong, or a file cannot be read or written.
inline constexpr int kExitUsage = 2;

}  // namespace clipc
