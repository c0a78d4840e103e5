// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "frontend/lex/token.h"
#include "frontend/parse/ast.h"
#include "frontend/parse/parse_options.h"

namespace clipc {

// Parses all of HLSL that fxc and DXC accept, for every shader stage; effects-framework text
// (techniques, state blocks, annotations) is skipped with its brackets matched. It is linear in the
// number of tokens, and every sequence of tokens has a result: text that nests too deeply for
// ast::kMaxDepth is an error. One run reports several syntax errors; a file is worth checking only
// if there are none.
ast::File Parse(Tokens tokens, Diagnostics& diagnostics,
                FunctionBodies bodies = FunctionBodies::kParse, const EffectParts& effect = {});

}  // namespace clipc
