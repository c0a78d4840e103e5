// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/lex/token_writer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace clipc {

void TokenWriter::AddHash(Token token) {
  token.kind = TokenKind::kUnknown;
  Add(token, after_ == After::kNumberWithDot && !token.after_space ? After::kHash : After::kOther);
}

// If `text` completes the special number that `1.#` began, puts it together and returns true.
bool TokenWriter::EndSpecialNumber(std::string_view text) {
  Number number;
  if (!ReadSpecialNumber(text, number)) return false;
  tokens_.list.pop_back();
  tokens_.list.back().literal = number.kind;
  tokens_.list.back().value = number.value;
  after_ = After::kOther;
  return true;
}

// Reads C's "preprocessing number", which may be a number and a swizzle or contain an operator:
// `1.0.yyy`, `0x1e+2`. Each part has a location of its own.
void TokenWriter::AddNumber(Token token, std::string_view text) {
  const auto is_digit = [&](std::size_t i) {
    return i < text.size() && text[i] >= '0' && text[i] <= '9';
  };
  while (!text.empty()) {
    std::size_t used = 1;
    const char c = text[0];
    if (is_digit(0) || (c == '.' && is_digit(1))) {
      used = AddOneNumber(token, text);
    } else if (c == '.' || c == '+' || c == '-') {
      token.kind = c == '.' ? TokenKind::kDot : c == '+' ? TokenKind::kPlus : TokenKind::kMinus;
      Add(token, After::kOther);
    } else {
      used = std::min(text.find_first_of(".+-"), text.size());
      token.value = tokens_.names.Intern(text.substr(0, used)).index;
      AddIdentifier(token, text.substr(0, used));
    }
    text.remove_prefix(used);
    token = Token{};
    token.location = tokens_.list.back().location + static_cast<std::uint32_t>(used);
  }
}

std::size_t TokenWriter::AddOneNumber(Token token, std::string_view text) {
  Number number = ReadNumber(text);
  if (number.problem == NumberProblem::kInfinite &&
      !std::isinf(std::bit_cast<double>(number.value))) {
    // From shader model 6 on such a literal may be a double.
    if (is_model_6_)
      number.problem = NumberProblem::kNone;
    else
      number.value = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
  }
  const bool is_foreign = number.is_binary && !is_model_6_;
  if (number.problem != NumberProblem::kNone || is_foreign) {
    if (number.problem == NumberProblem::kNotANumber) number.length = text.size();
    ReportNumber(token.span(), text.substr(0, number.length), number);
  }
  token.kind = IsFloatingPoint(number.kind) ? TokenKind::kFloatLiteral : TokenKind::kIntLiteral;
  token.literal = number.kind;
  token.value = number.value;
  const bool ends_in_dot = number.length == text.size() && text.back() == '.';
  Add(token, ends_in_dot ? After::kNumberWithDot : After::kOther);
  return number.length;
}

void TokenWriter::ReportNumber(Span where, std::string_view text, const Number& number) {
  const char* reason = "";
  switch (number.problem) {
    case NumberProblem::kNone: reason = "binary numbers begin with shader model 6.0"; break;
    case NumberProblem::kInfinite:
      diagnostics_.Report(where, diag::FloatLiteralRange, text);
      return;
    case NumberProblem::kNotANumber: reason = "the suffixes are u, l, ll, f and h"; break;
    case NumberProblem::kBadOctal: reason = "digits after a leading 0 are octal"; break;
    case NumberProblem::kTooLarge: reason = "an integer has at most 64 bits"; break;
  }
  diagnostics_.Report(where, diag::InvalidNumber, text, reason);
}

void TokenWriter::AddCharacter(Token token, std::string_view literal) {
  token.kind = TokenKind::kIntLiteral;
  token.value = CharacterValue(literal);
  Add(token, After::kOther);
}

void TokenWriter::AddString(Token token, std::string_view literal) {
  if (after_ != After::kString) string_ = token;
  after_ = After::kString;
  AppendUnescaped(literal, string_text_);
}

void TokenWriter::EndString() {
  string_.kind = TokenKind::kStringLiteral;
  string_.literal = LiteralKind::kString;
  string_.value = tokens_.names.Intern(string_text_).index;
  tokens_.list.push_back(string_);
  string_text_.clear();
}

void TokenWriter::AddEnd(std::uint32_t location) {
  Add({TokenKind::kEnd, LiteralKind::kInt, true, location, 0}, After::kOther);
}

}  // namespace clipc
