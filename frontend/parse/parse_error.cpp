// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <array>

#include "frontend/parse/parser.h"

// What the parser says when the text is not HLSL, and where it goes on reading.
namespace clipc::ast {
namespace {

// By TokenKind; empty for tokens that have no fixed spelling.
constexpr std::string_view Spelling(TokenKind kind) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(TokenKind::kUnknown) + 1>
      kSpellings = {
          "",   "",   "",   "",   "",    "(",  ")",  "[",  "]",   "{",   "}",  ";",  ",",  ":",
          "::", ".",  "?",  "->", "...", "+",  "-",  "*",  "/",   "%",   "&",  "|",  "^",  "~",
          "!",  "<",  ">",  "<=", ">=",  "==", "!=", "<<", ">>",  "&&",  "||", "++", "--", "=",
          "+=", "-=", "*=", "/=", "%=",  "&=", "|=", "^=", "<<=", ">>=", "",   ""};
  return kSpellings[static_cast<std::size_t>(kind)];
}
static_assert(Spelling(TokenKind::kEllipsis) == "..." && Spelling(TokenKind::kAmpAmp) == "&&" &&
              Spelling(TokenKind::kGreaterGreaterEqual) == ">>=");

}  // namespace

std::string Parser::Describe(std::size_t ahead) const {
  const Token& token = Peek(ahead);
  switch (token.kind) {
    case TokenKind::kEnd: return "end of file";
    case TokenKind::kIdentifier: return fmt::format("`{}`", Text(token.name()));
    case TokenKind::kIntLiteral: return fmt::format("`{}`", token.value);
    case TokenKind::kFloatLiteral: return "number";
    case TokenKind::kStringLiteral: return "string";
    case TokenKind::kUnknown: return "character";
    default: return fmt::format("`{}`", Spelling(token.kind));
  }
}

void Parser::Unexpected(std::string_view expected) {
  Error(Here(), diag::UnexpectedToken, Describe(), expected);
}

// Nothing more is read or said.
void Parser::Abort() {
  aborted_ = true;
  panic_ = true;
  pos_ = tokens_.size() - 1;
}

bool Parser::Expect(TokenKind kind, std::string_view expected) {
  if (Accept(kind)) return true;
  Unexpected(expected);
  return false;
}

// The bracket that closes the one at `open`.
bool Parser::ExpectClose(TokenKind close, std::size_t open) {
  if (Accept(close)) {
    panic_ = aborted_;
    return true;
  }
  if (panic_) return false;
  const std::string_view opened = Spelling(tokens_[open].kind);
  Diagnostic* report =
      Error(Here(), diag::UnexpectedToken, Describe(), fmt::format("`{}`", Spelling(close)));
  if (report) report->Note(tokens_[open].span(), diag::OpenedHere, opened);
  return false;
}

// The text of the last token consumed, where it is known.
std::string Parser::PreviousText() const {
  if (pos_ == 0) return {};
  const Token& token = tokens_[pos_ - 1];
  if (token.kind == TokenKind::kIdentifier) return std::string(Text(token.name()));
  return std::string(Spelling(token.kind));
}

// A missing `;` is reported where it is missing: after the token before. What follows is read as if
// it were there.
bool Parser::ExpectSemicolon(std::string_view after) {
  if (Accept(TokenKind::kSemicolon)) {
    panic_ = aborted_;
    return true;
  }
  if (panic_) return false;
  const bool new_phrase = At(TokenKind::kIdentifier) || At(TokenKind::kRightBrace) || AtEnd() ||
                          At(TokenKind::kLeftBracket);
  if (!new_phrase) {
    Error(Here(), diag::UnexpectedToken, Describe(), fmt::format("`;` after {}", after));
    if (At(TokenKind::kLeftBrace)) SkipBalanced();  // S s = S{1, 2};
    return false;
  }
  Diagnostic* report = Error(PreviousSpan(), diag::MissingSemicolon, after);
  std::string text = PreviousText();
  if (report && !text.empty()) report->Fix(PreviousSpan(), text + ";");
  // An unknown word in the middle of an expression more likely than a new statement: `a = b c;`.
  const bool in_step = !At(TokenKind::kIdentifier) || IsReserved(WordAt()) || IsDeclaration() ||
                       Peek(1).kind == TokenKind::kEqual || Peek(1).kind == TokenKind::kLeftParen ||
                       Peek(1).kind == TokenKind::kDot;
  if (in_step) panic_ = aborted_ || AtEnd();
  return in_step;
}

// A word that starts a declaration wherever it stands.
bool Parser::AtDeclarationWord() const {
  switch (WordAt()) {
    case Word::kStruct:
    case Word::kClass:
    case Word::kInterface:
    case Word::kTypedef:
    case Word::kNamespace:
    case Word::kEnum:
    case Word::kTemplate:
    case Word::kCbuffer:
    case Word::kTbuffer: return true;
    case Word::kTechnique:
      return Peek(1).kind == TokenKind::kIdentifier || Peek(1).kind == TokenKind::kLeftBrace;
    default: return false;
  }
}

// From an opening bracket to behind the one that closes it; kinds are not told apart.
void Parser::SkipBalanced() {
  int depth = 0;
  while (!AtEnd()) {
    switch (Next().kind) {
      case TokenKind::kLeftParen:
      case TokenKind::kLeftBracket:
      case TokenKind::kLeftBrace: ++depth; break;
      case TokenKind::kRightParen:
      case TokenKind::kRightBracket:
      case TokenKind::kRightBrace: --depth; break;
      default: break;
    }
    if (depth <= 0) return;
  }
}

// After an error inside brackets: behind the `close` that ends them, unless the statement ends
// first.
void Parser::SkipToClose(TokenKind close, bool past_semicolons) {
  int depth = 0;
  while (!AtEnd()) {
    const TokenKind kind = Peek().kind;
    if (depth == 0 && kind == close) {
      Next();
      panic_ = aborted_;
      return;
    }
    if (kind == TokenKind::kLeftBrace || kind == TokenKind::kRightBrace) return;
    if (kind == TokenKind::kSemicolon && !past_semicolons) return;
    if (kind == TokenKind::kLeftParen || kind == TokenKind::kLeftBracket) ++depth;
    if (kind == TokenKind::kRightParen || kind == TokenKind::kRightBracket) --depth;
    if (depth < 0) return;
    Next();
  }
}

// After an error in a statement: behind its `;`, or before a brace or a word that starts another.
void Parser::SyncStatement() {
  while (!AtEnd() && !At(TokenKind::kLeftBrace) && !At(TokenKind::kRightBrace)) {
    const Word word = WordAt();
    if (IsStatementWord(word) && word != Word::kElse) break;
    if (Next().kind == TokenKind::kSemicolon) break;
  }
  panic_ = aborted_ || AtEnd();
}

// After an error in a declaration: behind its `;` or its body, or before a word that starts
// another.
void Parser::SyncDeclaration(Scope scope) {
  const std::size_t start = pos_;
  while (!AtEnd()) {
    if (pos_ > start && AtDeclarationWord()) break;
    if (At(TokenKind::kRightBrace)) {
      if (scope != Scope::kGlobal) break;
      Next();
      Accept(TokenKind::kSemicolon);
      break;
    }
    if (At(TokenKind::kLeftBrace)) {
      SkipBalanced();
      Accept(TokenKind::kSemicolon);
      break;
    }
    if (Next().kind == TokenKind::kSemicolon) break;
  }
  panic_ = aborted_ || AtEnd();
}

}  // namespace clipc::ast
