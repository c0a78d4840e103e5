// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/name.h"
#include "frontend/lex/token.h"

namespace clipc::ast {

// What an effect gives to a state, as far as it is constant.
struct EffectValue {
  enum class Kind : std::uint8_t {
    kOther,   // it depends on a parameter, or has no known form
    kNumber,  // 0x7, -1.5, (2 + 1) / 3, TRUE
    kWord,    // LINEAR, (Linear), <Map>
    kUnion,   // RED | GREEN: `parts`
    kList     // {0, 0, 0, 1}, float4(0, 0, 0, 1), the arguments of a call: `parts`
  };
  Kind kind = Kind::kOther;
  double number = 0;  // exact for every integer that a state takes
  bool is_integer = false;
  std::string word;
  std::vector<EffectValue> parts = {};

  bool IsNumber() const { return kind == Kind::kNumber; }
};

// Reads what is right of the `=`. A longer text than a state needs is kOther, so that the time is
// linear in the text.
EffectValue ReadEffectValue(std::span<const Token> tokens, const Names& names);
// Reads the arguments of a call.
EffectValue ReadEffectArguments(std::span<const Token> tokens, const Names& names);

}  // namespace clipc::ast
