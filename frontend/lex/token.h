// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>

#include "base/kept_blocks.h"
#include "base/name.h"
#include "base/span.h"

namespace clipc {

enum class TokenKind : std::uint8_t {
  kEnd,
  kIdentifier,  // an identifier or a keyword; the parser tells them apart by Name
  kIntLiteral,
  kFloatLiteral,
  kStringLiteral,
#define PUNCTUATOR(kind, clang_kind, spelling) kind,
#include "frontend/lex/punctuators.def"
  kPragmaPackMatrix,  // `#pragma pack_matrix`; its value is 1 for row_major, 0 for column_major
  kUnknown,           // a character that HLSL does not have; the parser reports it
};

// The text of a punctuator; empty for the other kinds.
constexpr std::string_view SpellingOf(TokenKind kind) {
  switch (kind) {
#define PUNCTUATOR(kind, clang_kind, spelling) \
  case TokenKind::kind: return spelling;
#include "frontend/lex/punctuators.def"
    default: return {};
  }
}

// True for `=`, `+=` and so on.
constexpr bool IsAssignment(TokenKind kind) {
  switch (kind) {
#define PUNCTUATOR(kind, clang_kind, spelling)
#define ASSIGNMENT(kind, clang_kind, spelling) case TokenKind::kind:
#include "frontend/lex/punctuators.def"
    return true;
    default: return false;
  }
}

// Returns the change that a token makes to the depth of brackets: 1 for ( [ {, -1 for ) ] }, 0 for
// the rest.
constexpr int BracketStep(TokenKind kind) {
  switch (kind) {
    case TokenKind::kLeftParen:
    case TokenKind::kLeftBracket:
    case TokenKind::kLeftBrace: return 1;
    case TokenKind::kRightParen:
    case TokenKind::kRightBracket:
    case TokenKind::kRightBrace: return -1;
    default: return 0;
  }
}

// The type that a literal's suffix gives it. A number without a suffix is kInt or kFloat, or what
// ReadNumber says of large integers.
enum class LiteralKind : std::uint8_t {
  kBool,
  kInt,
  kHexadecimal,  // 0x3: an int or a uint, as the shader model has it
  kUint,
  kInt64,
  kUint64,
  kHalf,
  kFloat,
  kTypedFloat,  // 1.0f, which is a float beside a double too
  kDouble,
  kString
};

constexpr bool IsFloatingPoint(LiteralKind kind) {
  return kind >= LiteralKind::kHalf && kind <= LiteralKind::kDouble;
}

// One token, in sixteen bytes. `value` is the value of an integer literal, the bits of a double for
// a floating-point literal, the index of a Name for an identifier or a string literal.
struct Token {
  TokenKind kind = TokenKind::kEnd;
  LiteralKind literal = LiteralKind::kInt;
  bool after_space = false;  // whether white space or a comment precedes the token
  std::uint32_t location = 0;
  std::uint64_t value = 0;

  Name name() const { return Name{static_cast<std::uint32_t>(value)}; }
  Span span() const { return {location, location}; }
};

// A translation unit after preprocessing; the last token is kEnd.
struct Tokens {
  KeptVector<Token> list;
  Names names;
  bool has_pragmas = false;  // a kPragmaPackMatrix
};

}  // namespace clipc
