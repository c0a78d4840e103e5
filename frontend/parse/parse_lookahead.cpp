// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/parser.h"

// Where HLSL's grammar needs more than the current token. Every scan stops after kMaxLookahead
// tokens, so parsing stays linear whatever the text. A position is a number of tokens from the
// current one; 0 means "no".
namespace clipc::ast {
namespace {

constexpr std::size_t kMaxLookahead = 128;

bool IsOpening(TokenKind kind) {
  return kind == TokenKind::kLeftParen || kind == TokenKind::kLeftBracket;
}
bool IsClosing(TokenKind kind) {
  return kind == TokenKind::kRightParen || kind == TokenKind::kRightBracket;
}

}  // namespace

// Behind the `>` that belongs to the `<` at `ahead`.
std::size_t Parser::SkipTemplateArguments(std::size_t ahead) const {
  int angles = 0;
  int brackets = 0;
  for (std::size_t i = ahead; i < ahead + kMaxLookahead; ++i) {
    const TokenKind kind = Peek(i).kind;
    if (IsOpening(kind)) ++brackets;
    if (IsClosing(kind) && --brackets < 0) return 0;
    if (brackets > 0) continue;
    switch (kind) {
      case TokenKind::kLess: ++angles; break;
      case TokenKind::kGreater: --angles; break;
      case TokenKind::kGreaterGreater: angles -= 2; break;
      case TokenKind::kIdentifier:
      case TokenKind::kIntLiteral:
      case TokenKind::kComma:
      case TokenKind::kColonColon:
      case TokenKind::kPlus:
      case TokenKind::kMinus:
      case TokenKind::kStar:
      case TokenKind::kSlash:
      case TokenKind::kPercent:
      case TokenKind::kAmp:
      case TokenKind::kPipe:
      case TokenKind::kCaret:
      case TokenKind::kTilde:
      case TokenKind::kRightParen:
      case TokenKind::kRightBracket:
      case TokenKind::kDot: break;
      default: return 0;
    }
    if (angles == 0) return i + 1;
    if (angles < 0) return 0;
  }
  return 0;
}

// Behind the bracket that closes the one at `ahead`.
std::size_t Parser::SkipBrackets(std::size_t ahead) const {
  int depth = 0;
  for (std::size_t i = ahead; i < ahead + kMaxLookahead; ++i) {
    const TokenKind kind = Peek(i).kind;
    if (kind == TokenKind::kEnd || kind == TokenKind::kSemicolon) return 0;
    if (IsOpening(kind)) ++depth;
    if (IsClosing(kind) && --depth == 0) return i + 1;
  }
  return 0;
}

// Behind `a::b<c>` or `::a`; behind `unsigned int`.
std::size_t Parser::SkipTypeName(std::size_t ahead) const {
  std::size_t i = ahead;
  if (WordAt(i) == Word::kUnsigned) return WordAt(i + 1) == Word::kNumericType ? i + 2 : i + 1;
  if (Peek(i).kind == TokenKind::kColonColon) ++i;
  while (i < ahead + kMaxLookahead) {
    if (Peek(i).kind != TokenKind::kIdentifier) return 0;
    const bool variable = i == ahead && MeaningOf(Peek(i).name()) == Meaning::kValue;
    ++i;
    if (Peek(i).kind == TokenKind::kLess && !variable) {
      const std::size_t after = SkipTemplateArguments(i);
      if (after != 0) i = after;
    }
    if (Peek(i).kind != TokenKind::kColonColon) return i;
    ++i;
  }
  return 0;
}

bool Parser::IsQualifier(std::size_t ahead) const {
  const Word word = WordAt(ahead);
  if (word == Word::kQualifier) return true;
  if (word != Word::kContextualQualifier || MeaningOf(Peek(ahead).name()) == Meaning::kType)
    return false;
  // `precise float x`, `point VSOut p[1]`; but `float sample`, `sample = 1`.
  const Word next = WordAt(ahead + 1);
  return AtName(ahead + 1) || StartsType(ahead + 1) || next == Word::kCbuffer ||
         next == Word::kTbuffer;
}

std::size_t Parser::SkipQualifiers(std::size_t ahead) const {
  while (IsQualifier(ahead) && ahead < kMaxLookahead) ++ahead;
  return ahead;
}

// A token that can only belong to a type here: not a name that a variable has.
bool Parser::StartsType(std::size_t ahead) const {
  switch (WordAt(ahead)) {
    case Word::kQualifier:
    case Word::kStruct:
    case Word::kClass:
    case Word::kEnum:
    case Word::kInterface:
    case Word::kUnsigned:
    case Word::kTypename: return true;
    default: return IsTypeName(ahead);
  }
}

// `(T)e`, `(T[2])e`, as opposed to `(a) + b`.
bool Parser::IsCast() const {
  std::size_t i = SkipQualifiers(1);
  const bool qualified = i > 1;
  if (WordAt(i) == Word::kStruct || WordAt(i) == Word::kTypename) return true;
  std::size_t after = SkipTypeName(i);
  if (after == 0) return false;
  const Token& last = Peek(after - 1);
  const bool templated = last.kind != TokenKind::kIdentifier;
  const bool is_type = qualified || IsTypeName(templated ? i : after - 1);
  while (is_type && Peek(after).kind == TokenKind::kLeftBracket) {
    after = SkipBrackets(after);
    if (after == 0) return false;
  }
  if (Peek(after).kind != TokenKind::kRightParen) return false;
  if (is_type) return true;
  if (templated || MeaningOf(last.name()) != Meaning::kUnknown) return false;
  // A name nobody declared: it is a type if an operand follows.
  switch (Peek(after + 1).kind) {
    case TokenKind::kIdentifier:
    case TokenKind::kIntLiteral:
    case TokenKind::kFloatLiteral:
    case TokenKind::kLeftParen: return true;
    default: return false;
  }
}

// At the start of a statement: two names in a row are a type and a variable, whatever they mean.
bool Parser::IsDeclaration() const {
  switch (WordAt()) {
    case Word::kQualifier:
    case Word::kStruct:
    case Word::kClass:
    case Word::kInterface:
    case Word::kTypedef:
    case Word::kUsing:
    case Word::kEnum:
    case Word::kUnsigned:
    case Word::kStaticAssert:
    case Word::kTypename: return true;
    case Word::kNumericType:
      if (MeaningOf(Peek().name()) == Meaning::kValue) break;
      // `float;` and `float 2x;` are broken declarations rather than broken expressions; `float(x)`
      // is neither.
      return Peek(1).kind != TokenKind::kLeftParen && Peek(1).kind != TokenKind::kColonColon;
    default: break;
  }
  if (IsQualifier(0)) return true;
  if (!AtName() && !At(TokenKind::kColonColon)) return false;
  const std::size_t after = SkipTypeName(0);
  if (after == 0) return false;
  // `T [[attribute]] x`
  if (Peek(after).kind == TokenKind::kLeftBracket &&
      Peek(after + 1).kind == TokenKind::kLeftBracket)
    return true;
  return AtName(after) || WordAt(after) == Word::kQualifier || WordAt(after) == Word::kNumericType;
}

// Whether the `<` after the name of a function or type starts template arguments.
bool Parser::IsTemplateUse(Name name, std::size_t less) const {
  switch (MeaningOf(name)) {
    case Meaning::kFunctionTemplate:
    case Meaning::kType: return SkipTemplateArguments(less) != 0;
    case Meaning::kValue: return false;
    case Meaning::kUnknown:
      if (InfoOfName(name).word == Word::kObjectType) return true;
      return IsMemberTemplateUse(less);
    default: return IsMemberTemplateUse(less);
  }
}

// For a name whose declaration is not known: `<`, types, `>` and a call.
bool Parser::IsMemberTemplateUse(std::size_t less) const {
  if (Peek(less).kind != TokenKind::kLess || !StartsType(less + 1)) return false;
  const std::size_t after = SkipTemplateArguments(less);
  return after != 0 &&
         (Peek(after).kind == TokenKind::kLeftParen || Peek(after).kind == TokenKind::kColonColon);
}

// After the `}` of a struct: whether its declaration ends there although no `;` does. `struct S {}
// f() {}` and `struct S {} s;` go on; `struct S {} float4 f() {}`, `struct S {} struct T {}` do
// not.
bool Parser::StructEndsHere() const {
  switch (Peek().kind) {
    case TokenKind::kIdentifier: break;
    case TokenKind::kEnd:
    case TokenKind::kRightBrace:
    case TokenKind::kLeftBracket: return true;
    default: return false;
  }
  if (WordAt() == Word::kQualifier) return Peek(1).kind == TokenKind::kIdentifier;
  if (IsReserved(WordAt())) return true;
  const std::size_t after = SkipTypeName(0);
  if (after == 0) return false;
  if (Peek(after).kind == TokenKind::kIdentifier) return true;
  return AtDeclarationWord();
}

}  // namespace clipc::ast
