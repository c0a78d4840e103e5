// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "frontend/lex/source.h"
#include "frontend/lex/token.h"

namespace clipc {

// The text of --dump=tokens: a line for each token with its place, its kind and its value. The name
// of the file is on a line of its own where it changes.
std::string DumpTokens(const Tokens& tokens, const Source& source);

}  // namespace clipc
