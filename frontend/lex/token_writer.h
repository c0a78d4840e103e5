// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "frontend/lex/literal.h"
#include "frontend/lex/token.h"

namespace clipc {

// Appends tokens to a list, and turns C's preprocessing tokens into those of HLSL: reads numbers,
// joins adjacent string literals and the parts of `1.#INF`. The `token` of an Add function has its
// location and after_space; the writer fills in the rest.
class TokenWriter {
 public:
  // `is_model_6`: 0b101 is a number, and 1e300 is a double where one is wanted.
  TokenWriter(Tokens& tokens, Diagnostics& diagnostics, bool is_model_6)
      : tokens_(tokens), diagnostics_(diagnostics), is_model_6_(is_model_6) {}

  [[gnu::always_inline]] void AddPunctuator(Token token) { Add(token, After::kOther); }
  void AddPragma(Token token) {
    tokens_.has_pragmas = true;
    Add(token, After::kOther);
  }
  void AddHash(Token token);
  // `token.value` is the Name of `text`.
  [[gnu::always_inline]] void AddIdentifier(Token token, std::string_view text) {
    if (after_ == After::kHash && !token.after_space && EndSpecialNumber(text)) return;
    token.kind = TokenKind::kIdentifier;
    Add(token, After::kOther);
  }
  void AddNumber(Token token, std::string_view text);
  void AddCharacter(Token token, std::string_view literal);
  void AddString(Token token, std::string_view literal);
  void AddEnd(std::uint32_t location);

 private:
  // The kind of the token that was added last, as far as the next token depends on it.
  enum class After : std::uint8_t { kOther, kNumberWithDot, kHash, kString };

  [[gnu::always_inline]] void Add(Token token, After after) {
    if (after_ == After::kString) [[unlikely]]
      EndString();
    after_ = after;
    tokens_.list.push_back(token);
  }
  bool EndSpecialNumber(std::string_view text);
  void EndString();
  std::size_t AddOneNumber(Token token, std::string_view text);
  void ReportNumber(Span where, std::string_view text, const Number& number);

  Tokens& tokens_;
  Diagnostics& diagnostics_;
  bool is_model_6_;
  After after_ = After::kOther;
  Token string_;
  std::string string_text_;
};

}  // namespace clipc
