// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/diagnostics.h"
#include "base/kept_blocks.h"
#include "frontend/lex/token.h"
#include "frontend/parse/ast_decl.h"
#include "frontend/parse/keywords.h"

namespace clipc::ast {

// A place in a sequence of tokens, which reports errors there and finds the place where reading
// goes on after one. It knows words, brackets and lists, but not the grammar.
//
// After an error is reported the cursor is in panic: it reports nothing until a Skip or an Expect
// has found a place to go on from. After Abort it stays in panic at the end of the text.
//
// `ahead` counts tokens from the current one.
class TokenCursor {
 protected:
  using enum TokenKind;

  TokenCursor(Tokens&& tokens, Diagnostics& diagnostics);

  // ---- tokens
  const Token& Peek() const { return tokens_[pos_]; }
  const Token& Peek(std::size_t ahead) const {
    return tokens_[std::min(pos_ + ahead, tokens_.size() - 1)];
  }
  bool At(TokenKind kind) const { return Peek().kind == kind; }
  bool At(TokenKind kind, std::size_t ahead) const { return Peek(ahead).kind == kind; }
  bool AtEnd() const { return At(kEnd); }
  const Token& Next() { return AtEnd() ? tokens_[pos_] : tokens_[pos_++]; }
  void Skip(std::size_t tokens) {
    while (tokens-- > 0) Next();
  }
  bool Accept(TokenKind kind) {
    if (!At(kind) || AtEnd()) return false;
    ++pos_;
    return true;
  }
  // Accepts one `>`, which may be the start of `>>`, `>=` or `>>=`.
  bool AcceptGreater();

  Span Here() const { return Peek().span(); }
  Span PreviousSpan() const { return pos_ > 0 ? tokens_[pos_ - 1].span() : Here(); }
  // The span from the token at position `start` to the last token taken.
  Span SpanFrom(std::size_t start) const {
    return start >= pos_ ? Here() : Cover(tokens_[start].span(), tokens_[pos_ - 1].span());
  }

  // ---- words
  const WordInfo& InfoOf(Name name) const { return words_[name.index]; }
  Word WordAt(std::size_t ahead = 0) const {
    const Token& token = ahead == 0 ? Peek() : Peek(ahead);
    return token.kind == kIdentifier ? InfoOf(token.name()).word : Word::kNone;
  }
  bool AtWord(Word word) const { return WordAt() == word; }
  bool AtAnyOf(Words words) const { return words.Has(WordAt()); }
  // Whether the token at `ahead` is an identifier that can be the name of something.
  bool AtName(std::size_t ahead = 0) const {
    const Token& token = Peek(ahead);
    return token.kind == kIdentifier && !IsReserved(InfoOf(token.name()).word);
  }
  // Whether the current token is a word that starts a declaration in every context.
  bool AtDeclarationWord() const;
  std::string_view Text(Name name) const { return names_[name]; }
  // The text of the identifier at `ahead`; empty for another token.
  std::string_view TextAt(std::size_t ahead = 0) const {
    return At(kIdentifier, ahead) ? Text(Peek(ahead).name()) : std::string_view();
  }
  Name Intern(std::string_view text);

  // The bit of the last `#pragma pack_matrix` before the current token. It must be asked for in the
  // order of the text.
  Qualifiers PackingHere();

  // ---- errors
  // The current token as a message names it.
  std::string Describe() const;
  // The text of the last token taken if it is a word or a punctuator; otherwise empty.
  std::string PreviousText() const;
  template <typename... Args>
  Diagnostic* Error(Span where, const diag::Kind<Args...>& kind,
                    const std::type_identity_t<Args>&... args) {
    if (panic_) return nullptr;
    panic_ = true;
    Diagnostic& report = diagnostics_.Report(where, kind, args...);
    if (diagnostics_.TooManyErrors()) Abort();
    return &report;
  }
  void Unexpected(std::string_view expected) {
    Error(Here(), diag::UnexpectedToken, Describe(), expected);
  }
  // Ends the parse: nothing more is read or reported.
  void Abort();
  void EndPanic() { panic_ = aborted_; }

  // ---- expected tokens, and going on after an error
  bool Expect(TokenKind kind, std::string_view expected);
  // Reads the bracket that closes the one at position `open`, and ends the panic there. `or_else`
  // names the other tokens that could be there: "`,` or ".
  bool ExpectClose(TokenKind close, std::size_t open, std::string_view or_else = {});
  // Reads the bracket that closes the one at position `open`; if it is missing, goes on after the
  // next one that fits.
  void Close(TokenKind close, std::size_t open) {
    if (!ExpectClose(close, open)) SkipToClose(close);
  }
  // Reads elements with commas between them up to the `close` of the bracket at position `open`.
  // `after_comma` names the element that must follow a comma; empty: a trailing comma is allowed.
  template <typename ParseElement>
  void ParseList(TokenKind close, std::size_t open, std::string_view after_comma,
                 ParseElement element) {
    while (!At(close) && !AtEnd()) {
      element();
      if (panic_ || !Accept(TokenKind::kComma)) break;
      if (At(close) && !after_comma.empty()) Unexpected(after_comma);
    }
    if (panic_ || !ExpectClose(close, open, "`,` or ")) SkipToClose(close);
  }
  // Skips from an opening bracket past the bracket that closes it, whatever their kinds.
  void SkipBalanced();
  // Skips, after an error inside brackets, past the `close` that ends them, unless the statement
  // ends first.
  void SkipToClose(TokenKind close, bool past_semicolons = false);
  // Skips, after an error in a statement, past its `;`, or up to a brace or a word that starts
  // another statement.
  void SkipStatement();
  // Skips, after an error in a declaration, past its `;` or its body, or up to a word that starts
  // another declaration. `in_braces`: a `}` ends the scope of the declaration.
  void SkipDeclaration(bool in_braces);

  std::size_t pos_ = 0;
  bool panic_ = false;
  bool aborted_ = false;  // Abort was called; panic_ is then true as well
  KeptVector<Token> tokens_;
  Names names_;
  Diagnostics& diagnostics_;

 private:
  struct PackingChange {
    std::size_t position;
    bool row_major;
  };
  void RemovePragmas();

  KeptVector<PackingChange> packing_;
  std::size_t next_packing_ = 0;
  Qualifiers current_packing_ = 0;
  KeptVector<WordInfo> words_;  // by Name
};

}  // namespace clipc::ast
