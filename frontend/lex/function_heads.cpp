// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/lex/function_heads.h"

#include <algorithm>
#include <array>
#include <utility>

namespace clipc {
namespace {

// Whether a byte says nothing of where a body ends.
constexpr std::array<bool, 256> kIsDull = [] {
  std::array<bool, 256> dull;
  dull.fill(true);
  for (const char c : std::string_view("{}()[]/#\"'\\%\0", 13))
    dull[static_cast<unsigned char>(c)] = false;
  return dull;
}();

// The place after the comment, or the division, whose `/` is text[at]; npos for a comment that does
// not end, or that a backslash may make longer.
std::size_t AfterComment(std::string_view text, std::size_t at) {
  const char next = at + 1 < text.size() ? text[at + 1] : '\0';
  if (next != '/' && next != '*') return at + 1;
  const std::size_t end = next == '/' ? text.find('\n', at) : text.find("*/", at + 2);
  if (end == std::string_view::npos) return end;
  return text.substr(at, end - at).find('\\') == std::string_view::npos
             ? end + (next == '/' ? 1 : 2)
             : std::string_view::npos;
}

// Whether a declaration that begins with the word is a technique or a group of them.
bool BeginsTechnique(std::string_view word) {
  return word.starts_with("technique") || word == "fxgroup";
}

// Whether the word is followed by the shader that a variable holds.
bool Compiles(std::string_view word) { return word == "compile" || word == "CompileShader"; }

}  // namespace

using enum TokenKind;

void FunctionHeads::Reset() {
  first_ = function_ = Name();
  is_other_ = is_of_effect_ = false;
  parentheses_ = brackets_ = 0;
}

Name FunctionHeads::NextOutside(const Token& token) {
  before_ = std::exchange(last_, token.kind);
  switch (token.kind) {
    case kLeftBracket: ++brackets_; break;
    case kRightBracket: --brackets_; break;
    case kLeftParen: ++parentheses_; break;
    case kRightParen: --parentheses_; break;
    case kSemicolon: Reset(); break;
    case kEqual: is_other_ = is_other_ || (parentheses_ == 0 && brackets_ == 0); break;
    case kColon: is_other_ = is_other_ || !function_; break;
    case kIdentifier:
      if (!first_ && brackets_ == 0) {
        first_ = token.name();
        is_of_effect_ = BeginsTechnique(names_[first_]);
      } else if (is_other_ && Compiles(names_[token.name()])) {
        is_of_effect_ = true;
      }
      break;
    case kLeftBrace: {
      const bool is_plain = !is_other_ && parentheses_ == 0 && brackets_ == 0;
      const Name opened = is_plain ? function_ : Name();
      if (!opened && names_[first_] == "namespace") {
        ++namespaces_;
        Reset();
      } else {
        ++braces_;
      }
      return opened;
    }
    case kRightBrace:
      if (namespaces_ > 0) --namespaces_;
      Reset();
      break;
    default: break;
  }
  return Name();
}

std::optional<std::size_t> EndOfBody(std::string_view text, std::size_t begin) {
  int braces = 1, parentheses = 0, brackets = 0;
  for (std::size_t at = begin;;) {
    while (at < text.size() && kIsDull[static_cast<unsigned char>(text[at])]) ++at;
    if (at >= text.size()) return std::nullopt;
    switch (text[at]) {
      case '{': ++braces; break;
      case '}':
        if (--braces == 0)
          return parentheses == 0 && brackets == 0 ? std::optional(at) : std::nullopt;
        break;
      case '(': ++parentheses; break;
      case ')': --parentheses; break;
      case '[': ++brackets; break;
      case ']': --brackets; break;
      case '/':
        at = AfterComment(text, at);
        if (at == std::string_view::npos) return std::nullopt;
        continue;
      case '%':  // `<%`, `%>` and `%:` are other spellings of brackets and of `#`
        if (text[at - 1] == '<' || text.substr(at + 1).starts_with('>') ||
            text.substr(at + 1).starts_with(':'))
          return std::nullopt;
        break;
      default: return std::nullopt;
    }
    ++at;
  }
}

}  // namespace clipc
