// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>

#include "base/diagnostics.h"
#include "frontend/lex/token.h"
#include "frontend/parse/ast.h"

namespace clipc {

// Parses all of HLSL that fxc and DXC accept, for every shader stage; effects-framework text
// (techniques, state blocks, annotations) is skipped with its brackets matched. It is linear in the
// number of tokens, and every sequence of tokens has a result: text that nests too deeply for
// ast::kMaxDepth is an error. One run reports several syntax errors; a file is worth checking only
// if there are none.
//
// Bodies that are skipped, with their brackets matched, are empty blocks.
enum class FunctionBodies : std::uint8_t { kParse, kSkip };

// What is kept of the effects framework.
struct EffectParts {
  bool keep = false;  // fill ast::File::effect
  // The text of a call in a technique, "Main(true, 4)", as ast::TextOf gives it: its arguments are
  // parsed as expressions.
  std::string_view entry_call = {};
};
ast::File Parse(Tokens tokens, Diagnostics& diagnostics,
                FunctionBodies bodies = FunctionBodies::kParse, const EffectParts& effect = {});

}  // namespace clipc
