// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "frontend/lex/token.h"
#include "frontend/parse/ast.h"

namespace clipc {

// Whole HLSL as fxc and DXC accept it, whatever the shader stage; effects-framework text
// (techniques, state blocks, annotations) is skipped with its brackets matched. Linear in the
// number of tokens. Syntax errors are reported with recovery, several in one run; a file is worth
// checking only when there were none. Any token sequence is answered: what nests too deeply for the
// promise of ast::kMaxDepth is an error.
ast::File Parse(Tokens tokens, Diagnostics& diagnostics);

}  // namespace clipc
