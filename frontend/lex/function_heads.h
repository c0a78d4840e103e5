// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "base/name.h"
#include "frontend/lex/token.h"

namespace clipc {

// Follows the tokens of a file: finds where the body of a function begins, and the words that are
// there for anything but the name of a function that is declared. What an effect's techniques and
// shader variables compile is not used by the other functions.
class FunctionHeads {
 public:
  explicit FunctionHeads(const Names& names) : names_(names) {}

  // Reads the next token. Returns the name of the function whose body it opens; none for every
  // other token, for a body in a struct, and where the head is not a plain one. The token after
  // such a `{` may be the `}` of that body.
  // `use` is called with each word that is a use of a name.
  Name Next(const Token& token, auto&& use) {
    if (braces_ > 0) {
      NextInside({&token, 1}, use);
      return Name();
    }
    const bool is_word = IsWord(token);
    if (token.kind == TokenKind::kLeftParen && StartsParameters()) {
      function_ = word_;
    } else if (word_ && !is_of_effect_) {
      use(word_);
    }
    word_ = is_word ? token.name() : Name();
    return NextOutside(token);
  }

  bool is_inside() const { return braces_ > 0; }
  // Reads the tokens up to the end of the braces that are open, if there are any. Returns how many
  // these are.
  std::size_t NextInside(std::span<const Token> tokens, auto&& use) {
    int braces = braces_;
    std::size_t read = 0;
    for (; braces > 0 && read < tokens.size(); ++read) {
      const Token& token = tokens[read];
      if (IsWord(token) && !is_of_effect_) use(token.name());
      if (token.kind == TokenKind::kLeftBrace) ++braces;
      if (token.kind == TokenKind::kRightBrace) --braces;
    }
    if (std::exchange(braces_, braces) > 0 && braces == 0) Reset();
    return read;
  }

 private:
  static bool IsWord(const Token& token) {
    return token.kind == TokenKind::kIdentifier || token.kind == TokenKind::kStringLiteral;
  }
  void Reset();
  Name NextOutside(const Token& token);
  // Whether a `(` is that of the parameters of a function that is declared.
  bool StartsParameters() const {
    return word_ && !is_other_ && !function_ && parentheses_ == 0 && brackets_ == 0 &&
           (before_ == TokenKind::kIdentifier || before_ == TokenKind::kGreater ||
            before_ == TokenKind::kColonColon);
  }

  const Names& names_;
  int braces_ = 0, parentheses_ = 0, brackets_ = 0;  // that are open; no brace of a namespace
  int namespaces_ = 0;
  // Of the declaration that is read:
  Name first_, function_;
  bool is_other_ = false;      // it cannot be a function with a body
  bool is_of_effect_ = false;  // its words are not uses
  Name word_;                  // the last token, if it is a word
  TokenKind before_ = TokenKind::kEnd, last_ = TokenKind::kEnd;  // the last two tokens
};

// The place of the `}` that ends the body whose first byte is text[begin]. None for a body that
// only a preprocessor can read: with directives, strings, lines that go on in the next, or brackets
// that do not match.
std::optional<std::size_t> EndOfBody(std::string_view text, std::size_t begin);

}  // namespace clipc
