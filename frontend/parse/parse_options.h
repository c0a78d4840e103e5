// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>

namespace clipc {

// Bodies that are skipped, with their brackets matched, are empty blocks.
enum class FunctionBodies : std::uint8_t { kParse, kSkip };

// What is kept of the effects framework.
struct EffectParts {
  bool keep = false;  // fill ast::File::effect
  // The text of a call in a technique, "Main(true, 4)", as ast::TextOf gives it: its arguments are
  // parsed as expressions.
  std::string_view entry_call = {};
};

}  // namespace clipc
