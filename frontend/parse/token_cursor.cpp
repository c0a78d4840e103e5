// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/token_cursor.h"

#include <utility>

#include <fmt/format.h>

namespace clipc::ast {

TokenCursor::TokenCursor(Tokens&& tokens, Diagnostics& diagnostics)
    : tokens_(std::move(tokens.list)), names_(std::move(tokens.names)), diagnostics_(diagnostics) {
  if (tokens_.empty() || tokens_.back().kind != kEnd) tokens_.push_back(Token{});
  words_.reserve(names_.size());
  for (std::uint32_t i = 0; i < names_.size(); ++i) {
    words_.push_back(ClassifyWord(names_[Name{i}]));
  }
  if (tokens.has_pragmas) RemovePragmas();
}

// Moves the pragmas to a list of their own, so that looking ahead sees only the language.
void TokenCursor::RemovePragmas() {
  const auto is_pragma = [](const Token& token) { return token.kind == kPragmaPackMatrix; };
  const auto first = std::ranges::find_if(tokens_, is_pragma);
  auto kept = static_cast<std::size_t>(first - tokens_.begin());
  for (auto next = first; next != tokens_.end(); ++next) {
    const Token token = *next;
    if (is_pragma(token)) {
      packing_.push_back({kept, token.value != 0});
    } else {
      tokens_[kept++] = token;
    }
  }
  tokens_.resize(kept);
}

Qualifiers TokenCursor::PackingHere() {
  while (next_packing_ < packing_.size() && packing_[next_packing_].position <= pos_) {
    current_packing_ = packing_[next_packing_++].row_major ? kPackRowMajor : kPackColumnMajor;
  }
  return current_packing_;
}

bool TokenCursor::AcceptGreater() {
  TokenKind& kind = tokens_[pos_].kind;
  switch (kind) {
    case kGreater: Next(); return true;
    case kGreaterGreater: kind = kGreater; return true;
    case kGreaterEqual: kind = kEqual; return true;
    case kGreaterGreaterEqual: kind = kGreaterEqual; return true;
    default: return false;
  }
}

bool TokenCursor::AtDeclarationWord() const {
  if (AtWord(Word::kTechnique)) return At(kIdentifier, 1) || At(kLeftBrace, 1) || At(kLess, 1);
  return AtAnyOf(kTagWords | kOutsideWords | Word::kTypedef);
}

Name TokenCursor::Intern(std::string_view text) {
  const Name name = names_.Intern(text);
  if (name.index >= words_.size()) words_.push_back(ClassifyWord(text));
  return name;
}

// ---- errors

std::string TokenCursor::Describe() const {
  const Token& token = Peek();
  switch (token.kind) {
    case kEnd: return "end of file";
    case kIdentifier: return fmt::format("`{}`", Text(token.name()));
    case kIntLiteral: return fmt::format("`{}`", token.value);
    case kFloatLiteral: return "number";
    case kStringLiteral: return "string";
    case kUnknown: return "character";
    default: return fmt::format("`{}`", SpellingOf(token.kind));
  }
}

std::string TokenCursor::PreviousText() const {
  if (pos_ == 0) return {};
  const Token& token = tokens_[pos_ - 1];
  return std::string(token.kind == kIdentifier ? Text(token.name()) : SpellingOf(token.kind));
}

void TokenCursor::Abort() {
  aborted_ = true;
  panic_ = true;
  pos_ = tokens_.size() - 1;
}

bool TokenCursor::Expect(TokenKind kind, std::string_view expected) {
  if (Accept(kind)) return true;
  Unexpected(expected);
  return false;
}

bool TokenCursor::ExpectClose(TokenKind close, std::size_t open, std::string_view or_else) {
  if (Accept(close)) {
    EndPanic();
    return true;
  }
  const std::string expected = fmt::format("{}`{}`", or_else, SpellingOf(close));
  if (Diagnostic* report = Error(Here(), diag::UnexpectedToken, Describe(), expected))
    report->Note(tokens_[open].span(), diag::OpenedHere, SpellingOf(tokens_[open].kind));
  return false;
}

// ---- going on after an error

void TokenCursor::SkipBalanced() {
  for (int depth = 0; !AtEnd();) {
    depth += BracketStep(Next().kind);
    if (depth <= 0) return;
  }
}

void TokenCursor::SkipToClose(TokenKind close, bool past_semicolons) {
  for (int depth = 0; !AtEnd(); Next()) {
    if (depth == 0 && Accept(close)) return EndPanic();
    if (At(kLeftBrace) || At(kRightBrace) || (At(kSemicolon) && !past_semicolons)) return;
    depth += BracketStep(Peek().kind);
    if (depth < 0) return;
  }
}

void TokenCursor::SkipStatement() {
  while (!AtEnd() && !At(kLeftBrace) && !At(kRightBrace)) {
    if (IsStatementWord(WordAt()) && !AtWord(Word::kElse)) break;
    if (Next().kind == kSemicolon) break;
  }
  panic_ = aborted_ || AtEnd();
}

void TokenCursor::SkipDeclaration(bool in_braces) {
  const std::size_t start = pos_;
  while (!AtEnd()) {
    if (pos_ > start && AtDeclarationWord()) break;
    if (At(kRightBrace) && in_braces) break;
    if (At(kRightBrace) || At(kLeftBrace)) {
      SkipBalanced();  // takes only the `}` if it is one
      Accept(kSemicolon);
      break;
    }
    if (Next().kind == kSemicolon) break;
  }
  panic_ = aborted_ || AtEnd();
}

}  // namespace clipc::ast
