// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/lookahead.h"

namespace clipc::ast {
namespace {

// The largest number of tokens that a question reads.
constexpr std::size_t kMaxLookahead = 128;

// Returns the BracketStep of a token, but 0 for a brace.
int StepWithoutBraces(TokenKind kind) {
  return kind == TokenKind::kLeftBrace || kind == TokenKind::kRightBrace ? 0 : BracketStep(kind);
}

}  // namespace

// ---- names

Lookahead::Lookahead(Tokens&& tokens, Diagnostics& diagnostics)
    : TokenCursor(std::move(tokens), diagnostics),
      meanings_(names_.size()),
      outside_(names_.size()) {
  undo_.reserve(64);
}

Lookahead::NameScope::~NameScope() {
  while (names_.undo_.size() > mark_) {
    const auto [name, meaning] = names_.undo_.back();
    names_.meanings_[name.index] = meaning;
    names_.undo_.pop_back();
  }
}

void Lookahead::Declare(Name name, Meaning meaning) {
  if (!name) return;
  if (name.index >= meanings_.size()) {
    meanings_.resize(names_.size());
    outside_.resize(names_.size());
  }
  // A template keeps its arguments whatever overloads follow.
  Meaning& current = meanings_[name.index];
  if (meaning == Meaning::kFunction && current == Meaning::kFunctionTemplate) return;
  if (current != meaning) undo_.emplace_back(name, std::exchange(current, meaning));
  if (meaning == Meaning::kType || meaning == Meaning::kFunctionTemplate)
    outside_[name.index] = meaning;
}

Lookahead::Meaning Lookahead::MeaningOf(Name name) const {
  if (name.index >= meanings_.size()) return Meaning::kUnknown;
  const Meaning meaning = meanings_[name.index];
  return meaning == Meaning::kUnknown ? outside_[name.index] : meaning;
}

bool Lookahead::IsTypeName(std::size_t ahead) const {
  const Token& token = Peek(ahead);
  if (token.kind != kIdentifier) return false;
  const Meaning meaning = MeaningOf(token.name());
  if (meaning != Meaning::kUnknown) return meaning == Meaning::kType;
  return kTypeNameWords.Has(WordAt(ahead));
}

// ---- skipping

std::size_t Lookahead::SkipTemplateArguments(std::size_t ahead) const {
  int angles = 0;
  int brackets = 0;
  for (std::size_t i = ahead; i < ahead + kMaxLookahead; ++i) {
    const TokenKind kind = Peek(i).kind;
    brackets += StepWithoutBraces(kind);
    if (brackets < 0) return 0;
    if (brackets > 0) continue;
    switch (kind) {
      case kLess: ++angles; break;
      case kGreater: --angles; break;
      case kGreaterGreater: angles -= 2; break;
      case kIdentifier:
      case kIntLiteral:
      case kComma:
      case kColonColon:
      case kPlus:
      case kMinus:
      case kStar:
      case kSlash:
      case kPercent:
      case kAmp:
      case kPipe:
      case kCaret:
      case kTilde:
      case kRightParen:
      case kRightBracket:
      case kDot: break;
      default: return 0;
    }
    if (angles == 0) return i + 1;
    if (angles < 0) return 0;
  }
  return 0;
}

std::size_t Lookahead::SkipBrackets(std::size_t ahead) const {
  int depth = 0;
  for (std::size_t i = ahead; i < ahead + kMaxLookahead; ++i) {
    const TokenKind kind = Peek(i).kind;
    if (kind == kEnd || kind == kSemicolon) return 0;
    const int step = StepWithoutBraces(kind);
    depth += step;
    if (step < 0 && depth == 0) return i + 1;
  }
  return 0;
}

std::size_t Lookahead::SkipTypeName(std::size_t ahead) const {
  std::size_t i = ahead;
  if (WordAt(i) == Word::kUnsigned) return WordAt(i + 1) == Word::kNumericType ? i + 2 : i + 1;
  if (At(kColonColon, i)) ++i;
  while (i < ahead + kMaxLookahead) {
    if (!At(kIdentifier, i)) return 0;
    const bool variable = i == ahead && MeaningOf(Peek(i).name()) == Meaning::kValue;
    ++i;
    if (At(kLess, i) && !variable) {
      const std::size_t after = SkipTemplateArguments(i);
      if (after != 0) i = after;
    }
    if (!At(kColonColon, i)) return i;
    ++i;
  }
  return 0;
}

bool Lookahead::IsQualifier(std::size_t ahead) const {
  const Word word = WordAt(ahead);
  if (word == Word::kQualifier) return true;
  if (word != Word::kContextualQualifier || MeaningOf(Peek(ahead).name()) == Meaning::kType)
    return false;
  // `precise float x`, `point VSOut p[1]`; but `float sample`, `sample = 1`.
  return AtName(ahead + 1) || StartsType(ahead + 1) || kBufferWords.Has(WordAt(ahead + 1));
}

std::size_t Lookahead::SkipQualifiers(std::size_t ahead) const {
  while (IsQualifier(ahead) && ahead < kMaxLookahead) ++ahead;
  return ahead;
}

std::size_t Lookahead::LastOfQualifiedName(std::size_t ahead) const {
  if (At(kColonColon, ahead)) ++ahead;
  while (At(kColonColon, ahead + 1) && AtName(ahead + 2)) ahead += 2;
  return ahead;
}

// ---- questions

bool Lookahead::StartsType(std::size_t ahead) const {
  return kTypeWords.Has(WordAt(ahead)) || IsTypeName(ahead);
}

bool Lookahead::IsCast() const {
  std::size_t i = SkipQualifiers(1);
  const bool qualified = i > 1;
  if (WordAt(i) == Word::kStruct || WordAt(i) == Word::kTypename) return true;
  std::size_t after = SkipTypeName(i);
  if (after == 0) return false;
  const Token& last = Peek(after - 1);
  const bool templated = last.kind != kIdentifier;
  const bool is_type = qualified || IsTypeName(templated ? i : after - 1);
  while (is_type && At(kLeftBracket, after)) {
    after = SkipBrackets(after);
    if (after == 0) return false;
  }
  if (!At(kRightParen, after)) return false;
  if (is_type) return true;
  if (templated || MeaningOf(last.name()) != Meaning::kUnknown) return false;
  // A name without a declaration is a type if an operand follows.
  switch (Peek(after + 1).kind) {
    case kIdentifier:
    case kIntLiteral:
    case kFloatLiteral:
    case kLeftParen: return true;
    default: return false;
  }
}

bool Lookahead::IsDeclaration() const {
  if (AtAnyOf(kTypeWords | Words(Word::kTypedef, Word::kUsing, Word::kStaticAssert))) return true;
  // `float;` and `float 2x;` are broken declarations rather than broken expressions; `float(x)` is
  // neither.
  if (AtWord(Word::kNumericType) && MeaningOf(Peek().name()) != Meaning::kValue)
    return !At(kLeftParen, 1) && !At(kColonColon, 1);
  if (IsQualifier(0)) return true;
  if (!AtName() && !At(kColonColon)) return false;
  const std::size_t after = SkipTypeName(0);
  if (after == 0) return false;
  // `T [[attribute]] x`
  if (At(kLeftBracket, after) && At(kLeftBracket, after + 1)) return true;
  return AtName(after) || Words(Word::kQualifier, Word::kNumericType).Has(WordAt(after));
}

bool Lookahead::IsTemplateUse(Name name, std::size_t less) const {
  switch (MeaningOf(name)) {
    case Meaning::kFunctionTemplate:
    case Meaning::kType: return SkipTemplateArguments(less) != 0;
    case Meaning::kValue: return false;
    case Meaning::kUnknown:
      return InfoOf(name).word == Word::kObjectType || IsMemberTemplateUse(less);
    default: return IsMemberTemplateUse(less);
  }
}

bool Lookahead::IsMemberTemplateUse(std::size_t less) const {
  if (!At(kLess, less) || !StartsType(less + 1)) return false;
  const std::size_t after = SkipTemplateArguments(less);
  return after != 0 && (At(kLeftParen, after) || At(kColonColon, after));
}

bool Lookahead::StructEndsHere() const {
  switch (Peek().kind) {
    case kIdentifier: break;
    case kEnd:
    case kRightBrace:
    case kLeftBracket: return true;
    default: return false;
  }
  if (WordAt() == Word::kQualifier) return At(kIdentifier, 1);
  if (IsReserved(WordAt())) return true;
  const std::size_t after = SkipTypeName(0);
  return after != 0 && (At(kIdentifier, after) || AtDeclarationWord());
}

}  // namespace clipc::ast
