// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "frontend/lex/source.h"
#include "frontend/lex/token.h"

namespace clipc {

// For --dump=tokens: a line per token, its place (the file's name where it changes), its kind, its
// value.
std::string DumpTokens(const Tokens& tokens, const Source& source);

}  // namespace clipc
