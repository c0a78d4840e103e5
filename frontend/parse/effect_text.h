// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/kept_blocks.h"
#include "base/name.h"
#include "base/span.h"
#include "frontend/lex/token.h"

// The text of an effect that has no meaning for a shader: what ReadEffect (effect.h) reads.
namespace clipc::ast {

struct TokenRange {
  std::size_t begin = 0, end = 0;
};

// A variable outside of functions and structs.
struct EffectVariable {
  Name name;
  Name semantic;  // may be none
  TokenRange type, dimensions, annotations;
  TokenRange value;  // what follows the `=`, or the block of states
};

struct EffectText {
  KeptVector<Token> tokens;            // of the whole file; ranges count in it
  std::vector<TokenRange> techniques;  // with their groups
  std::vector<EffectVariable> variables;
};

// The tokens as text, with a blank where the source has white space.
std::string TextOf(std::span<const Token> tokens, const Names& names);

// The most tokens of a call in a technique, `Main(true, 4)`. A longer one is not compiled.
inline constexpr std::size_t kMaxCallTokens = 1000;

}  // namespace clipc::ast
