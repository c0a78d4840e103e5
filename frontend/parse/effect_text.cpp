// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/effect_text.h"

#include <bit>

#include <fmt/format.h>

namespace clipc::ast {
namespace {

std::string FloatText(const Token& token) {
  std::string text = fmt::format("{}", std::bit_cast<double>(token.value));
  if (text.find_first_not_of("0123456789") == std::string::npos) text += ".0";
  if (token.literal == LiteralKind::kHalf) text += 'h';
  if (token.literal == LiteralKind::kDouble) text += 'L';
  return text;
}

std::string TextOfToken(const Token& token, const Names& names) {
  using enum TokenKind;
  switch (token.kind) {
    case kIdentifier: return std::string(names[token.name()]);
    case kIntLiteral:
      return token.literal == LiteralKind::kHexadecimal ? fmt::format("0x{:X}", token.value)
             : token.literal == LiteralKind::kUint      ? fmt::format("{}u", token.value)
                                                        : fmt::format("{}", token.value);
    case kFloatLiteral: return FloatText(token);
    case kStringLiteral: return fmt::format("\"{}\"", names[token.name()]);
    default: return std::string(SpellingOf(token.kind));
  }
}

}  // namespace

std::string TextOf(std::span<const Token> tokens, const Names& names) {
  std::string text;
  for (const Token& token : tokens) {
    if (token.after_space && !text.empty()) text += ' ';
    text += TextOfToken(token, names);
  }
  return text;
}

}  // namespace clipc::ast
