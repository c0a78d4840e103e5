// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "frontend/lex/source.h"

namespace clipc {

// Longer sources are refused: a Span has 31 bits for every file of a compile and every macro
// expansion in it.
inline constexpr std::size_t kMaxSourceBytes = std::size_t{256} << 20;

// Reads a whole file, pipe or device, "-" being standard input. Empty on success, else the reason
// in lower case.
std::string ReadText(const std::string& path, std::string& text);

// The macros there are before the first line: clipc's own, those of the compiler that the shader
// model belongs to, and the user's, which messages place in "<command line>".
std::string Predefines(const SourceInput& input);

// What stands after `#pragma warning`: (disable: 3206 3571; error: 4000). The numbers are fxc's.
// push, pop and anything else is taken without effect.
void ApplyWarningPragma(const std::vector<std::string>& words, Diagnostics& diagnostics);

}  // namespace clipc
