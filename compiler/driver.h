// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string_view>

namespace clipc {

// Runs the clipc program, which was built from `commit`; empty if that is not known. `arguments` do
// not include the name of the program. Returns the exit code.
int RunCommandLine(std::span<const char* const> arguments, std::string_view commit = {});

}  // namespace clipc
