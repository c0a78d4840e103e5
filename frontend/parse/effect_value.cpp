// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/effect_value.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/spelling.h"
#include "frontend/parse/effect_text.h"

namespace clipc::ast {
namespace {

using enum TokenKind;
using TokenSpan = std::span<const Token>;
using Kind = EffectValue::Kind;

constexpr std::size_t kMaxTokens = 128;

// The parts between tokens of the kind that are outside of brackets.
std::vector<TokenSpan> Split(TokenSpan tokens, TokenKind at) {
  std::vector<TokenSpan> parts;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    depth += BracketStep(tokens[i].kind);
    if (depth != 0 || tokens[i].kind != at) continue;
    parts.push_back(tokens.subspan(begin, i - begin));
    begin = i + 1;
  }
  parts.push_back(tokens.subspan(begin));
  return parts;
}

EffectValue Number(double number, bool is_integer) {
  return {.kind = Kind::kNumber, .number = number, .is_integer = is_integer, .word = {}};
}

// Computes an expression of literals, which has at most + - * / and parentheses.
class Arithmetic {
 public:
  explicit Arithmetic(TokenSpan tokens) : tokens_(tokens) {}

  EffectValue Compute() {
    const std::optional<EffectValue> sum = Sum();
    return sum && pos_ == tokens_.size() ? *sum : EffectValue();
  }

 private:
  bool Accept(TokenKind kind) {
    const bool is_there = pos_ < tokens_.size() && tokens_[pos_].kind == kind;
    pos_ += is_there ? 1 : 0;
    return is_there;
  }

  std::optional<EffectValue> Sum() {
    std::optional<EffectValue> left = Product();
    while (left) {
      const bool is_less = Accept(kMinus);
      if (!is_less && !Accept(kPlus)) break;
      const std::optional<EffectValue> right = Product();
      if (!right) return std::nullopt;
      left = Number(is_less ? left->number - right->number : left->number + right->number,
                    left->is_integer && right->is_integer);
    }
    return left;
  }

  std::optional<EffectValue> Product() {
    std::optional<EffectValue> left = Factor();
    while (left) {
      const bool divides = Accept(kSlash);
      if (!divides && !Accept(kStar)) break;
      const std::optional<EffectValue> right = Factor();
      if (!right || (divides && right->number == 0)) return std::nullopt;
      const bool is_integer = left->is_integer && right->is_integer;
      const double value = divides ? left->number / right->number : left->number * right->number;
      left = Number(is_integer ? std::trunc(value) : value, is_integer);
    }
    return left;
  }

  std::optional<EffectValue> Factor() {
    if (Accept(kMinus)) {
      const std::optional<EffectValue> value = Factor();
      return value ? std::optional(Number(-value->number, value->is_integer)) : std::nullopt;
    }
    if (Accept(kPlus)) return Factor();
    if (Accept(kLeftParen)) {
      std::optional<EffectValue> value = Sum();
      return Accept(kRightParen) ? value : std::nullopt;
    }
    if (Accept(kIntLiteral)) return Number(static_cast<double>(tokens_[pos_ - 1].value), true);
    if (Accept(kFloatLiteral)) return Number(std::bit_cast<double>(tokens_[pos_ - 1].value), false);
    return std::nullopt;
  }

  TokenSpan tokens_;
  std::size_t pos_ = 0;
};

class ValueReader {
 public:
  explicit ValueReader(const Names& names) : names_(names) {}

  EffectValue Read(TokenSpan tokens) const {
    while (IsEnclosed(tokens, kLeftParen, kRightParen)) tokens = Inside(tokens);
    if (tokens.empty()) return {};
    if (const std::vector<TokenSpan> parts = Split(tokens, kPipe); parts.size() > 1)
      return WithParts(Kind::kUnion, parts);
    if (IsEnclosed(tokens, kLeftBrace, kRightBrace)) return List(Inside(tokens));
    if (IsEnclosed(tokens, kLess, kGreater)) return Read(Inside(tokens));
    if (tokens[0].kind != kIdentifier) return Arithmetic(tokens).Compute();
    const std::string_view word = names_[tokens[0].name()];
    if (tokens.size() == 1) return Word(word);
    if (IsVector(word) && IsEnclosed(tokens.subspan(1), kLeftParen, kRightParen))
      return Repeated(List(Inside(tokens.subspan(1))), word);
    return {};
  }

  EffectValue List(TokenSpan tokens) const {
    return tokens.empty() ? WithParts(Kind::kList, {})
                          : WithParts(Kind::kList, Split(tokens, kComma));
  }

 private:
  static TokenSpan Inside(TokenSpan tokens) { return tokens.subspan(1, tokens.size() - 2); }

  // Whether the tokens are in one pair of such brackets.
  static bool IsEnclosed(TokenSpan tokens, TokenKind open, TokenKind close) {
    if (tokens.size() < 2 || tokens.front().kind != open || tokens.back().kind != close)
      return false;
    int depth = 0;
    for (const Token& token : tokens.first(tokens.size() - 1)) {
      depth += BracketStep(token.kind);
      if (depth == 0 && open != kLess) return false;
    }
    return true;
  }

  static bool IsVector(std::string_view word) {
    constexpr std::string_view kTypes[] = {"float", "half",   "int",    "uint",
                                           "bool",  "double", "vector", "matrix"};
    return std::ranges::any_of(kTypes,
                               [&](std::string_view type) { return word.starts_with(type); });
  }

  // float4(0) has four zeros.
  static EffectValue Repeated(EffectValue list, std::string_view type) {
    const char last = type.back();
    if (list.parts.size() == 1 && list.parts[0].IsNumber() && last >= '1' && last <= '4')
      list.parts.resize(static_cast<std::size_t>(last - '0'), EffectValue(list.parts[0]));
    return list;
  }

  static EffectValue Word(std::string_view word) {
    if (EqualIgnoringCase(word, "true")) return Number(1, true);
    if (EqualIgnoringCase(word, "false")) return Number(0, true);
    return {.kind = Kind::kWord, .word = std::string(word)};
  }

  EffectValue WithParts(Kind kind, const std::vector<TokenSpan>& parts) const {
    EffectValue value{.kind = kind, .word = {}};
    for (const TokenSpan part : parts) {
      if (!part.empty()) value.parts.push_back(Read(part));
    }
    return value;
  }

  const Names& names_;
};

}  // namespace

EffectValue ReadEffectValue(TokenSpan tokens, const Names& names) {
  return tokens.size() > kMaxTokens ? EffectValue() : ValueReader(names).Read(tokens);
}

EffectValue ReadEffectArguments(TokenSpan tokens, const Names& names) {
  return tokens.size() > kMaxTokens ? EffectValue() : ValueReader(names).List(tokens);
}

}  // namespace clipc::ast
