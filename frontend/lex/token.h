// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/names.h"
#include "base/span.h"

namespace clipc {

enum class TokenKind : std::uint8_t {
  kEnd,
  kIdentifier,  // keywords too: the parser tells them apart by Name
  kIntLiteral,
  kFloatLiteral,
  kStringLiteral,
  kLeftParen,
  kRightParen,
  kLeftBracket,
  kRightBracket,
  kLeftBrace,
  kRightBrace,
  kSemicolon,
  kComma,
  kColon,
  kColonColon,
  kDot,
  kQuestion,
  kArrow,
  kEllipsis,
  kPlus,
  kMinus,
  kStar,
  kSlash,
  kPercent,
  kAmp,
  kPipe,
  kCaret,
  kTilde,
  kExclaim,
  kLess,
  kGreater,
  kLessEqual,
  kGreaterEqual,
  kEqualEqual,
  kExclaimEqual,
  kLessLess,
  kGreaterGreater,
  kAmpAmp,
  kPipePipe,
  kPlusPlus,
  kMinusMinus,
  kEqual,
  kPlusEqual,
  kMinusEqual,
  kStarEqual,
  kSlashEqual,
  kPercentEqual,
  kAmpEqual,
  kPipeEqual,
  kCaretEqual,
  kLessLessEqual,
  kGreaterGreaterEqual,
  kPragmaPackMatrix,  // value 1: row_major from here on, 0: column_major
  kUnknown,           // a character HLSL has no use for; the parser reports it
};

// What a literal's suffix says it is; no suffix: kInt or kFloat.
enum class LiteralKind : std::uint8_t {
  kBool,
  kInt,
  kUint,
  kInt64,
  kUint64,
  kHalf,
  kFloat,
  kDouble,
  kString
};

// Sixteen bytes. `value` is an integer literal's value, a float literal's bits as a double, an
// identifier's or a string literal's Name index.
struct Token {
  TokenKind kind = TokenKind::kEnd;
  LiteralKind literal = LiteralKind::kInt;
  bool after_space = false;  // white space or a comment stands before it
  std::uint32_t location = 0;
  std::uint64_t value = 0;

  Name name() const { return Name{static_cast<std::uint32_t>(value)}; }
  Span span() const { return {location, location}; }
};

// A translation unit after preprocessing; the last token is kEnd.
struct Tokens {
  std::vector<Token> list;
  Names names;
};

}  // namespace clipc
