// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/parse.h"

#include <algorithm>

#include "frontend/parse/parser.h"

namespace clipc {

ast::File Parse(Tokens tokens, Diagnostics& diagnostics) {
  return ast::Parser(std::move(tokens), diagnostics).Run();
}

}  // namespace clipc

namespace clipc::ast {
namespace {

// Of brackets, blocks, prefix operators, ...: what the parser's own recursion may take of the
// stack.
constexpr int kMaxNesting = 256;
// Statements and declarations on one path; the rest of kMaxDepth is left to the expressions below
// them.
constexpr int kMaxStatementDepth = kMaxDepth / 2;

}  // namespace

Parser::Nesting::Nesting(Parser& parser, int weight) : parser_(parser), weight_(weight) {
  ++parser_.nesting_;
  parser_.depth_ += weight_;
  parser_.deepest_ = std::max(parser_.deepest_, parser_.depth_);
  ok_ = parser_.nesting_ <= kMaxNesting && parser_.depth_ <= kMaxStatementDepth;
  if (ok_) return;
  const int limit = parser_.nesting_ > kMaxNesting ? kMaxNesting : kMaxStatementDepth;
  parser_.Error(parser_.Here(), diag::NestedTooDeeply, limit);
  parser_.Abort();
}

Parser::Nesting::~Nesting() {
  --parser_.nesting_;
  parser_.depth_ -= weight_;
}

Parser::NameScope::~NameScope() {
  while (parser_.undo_.size() > mark_) {
    auto [name, meaning] = parser_.undo_.back();
    parser_.meanings_[name.index] = meaning;
    parser_.undo_.pop_back();
  }
}

Parser::Parser(Tokens tokens, Diagnostics& diagnostics)
    : diagnostics_(diagnostics), tokens_(std::move(tokens.list)) {
  file_.names = std::move(tokens.names);
  if (tokens_.empty() || tokens_.back().kind != TokenKind::kEnd) tokens_.push_back(Token{});
  words_.reserve(file_.names.size());
  for (std::uint32_t i = 0; i < file_.names.size(); ++i) {
    words_.push_back(ClassifyWord(file_.names[Name{i}]));
  }
  meanings_.resize(words_.size());
  beyond_.resize(words_.size());
  heights_.reserve(tokens_.size() / 2);  // a guess that is seldom too small
  type_heights_.reserve(64);
  undo_.reserve(64);
  name_stack_.reserve(8);
  RemovePragmas();
}

File Parser::Run() {
  ParseTopLevel();
  return std::move(file_);
}

// So that looking ahead sees the language only.
void Parser::RemovePragmas() {
  const auto is_pragma = [](const Token& token) {
    return token.kind == TokenKind::kPragmaPackMatrix;
  };
  const auto first = std::find_if(tokens_.begin(), tokens_.end(), is_pragma);
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

// The bit of the last #pragma pack_matrix before the current token.
Qualifiers Parser::PackingHere() {
  while (next_packing_ < packing_.size() && packing_[next_packing_].position <= pos_) {
    current_packing_ = packing_[next_packing_++].row_major ? kPackRowMajor : kPackColumnMajor;
  }
  return current_packing_;
}

// ---- tokens

Span Parser::PreviousSpan() const { return pos_ > 0 ? tokens_[pos_ - 1].span() : Here(); }

// Takes the `>` off a `>>`, `>=` or `>>=` that closes a list.
void Parser::SplitGreater() {
  Token& token = tokens_[pos_];
  switch (token.kind) {
    case TokenKind::kGreaterGreater: token.kind = TokenKind::kGreater; break;
    case TokenKind::kGreaterEqual: token.kind = TokenKind::kEqual; break;
    case TokenKind::kGreaterGreaterEqual: token.kind = TokenKind::kGreaterEqual; break;
    default: Next(); break;
  }
}

// ---- names

Name Parser::Intern(std::string_view text) {
  Name name = file_.names.Intern(text);
  if (name.index >= words_.size()) {
    words_.push_back(ClassifyWord(text));
    meanings_.push_back(Meaning::kUnknown);
    beyond_.push_back(Meaning::kUnknown);
  }
  return name;
}

void Parser::Declare(Name name, Meaning meaning) {
  if (!name) return;
  // A template keeps its arguments whatever overloads follow.
  Meaning& current = meanings_[name.index];
  if (meaning == Meaning::kFunction && current == Meaning::kFunctionTemplate) return;
  if (current != meaning) {
    undo_.emplace_back(name, current);
    current = meaning;
  }
  if (meaning == Meaning::kType || meaning == Meaning::kFunctionTemplate) {
    beyond_[name.index] = meaning;
  }
}

// What is declared in a scope that has been left (a namespace, a base class) counts when nothing
// nearer does.
Parser::Meaning Parser::MeaningOf(Name name) const {
  Meaning meaning = meanings_[name.index];
  return meaning == Meaning::kUnknown ? beyond_[name.index] : meaning;
}

bool Parser::IsTypeName(std::size_t ahead) const {
  const Token& token = Peek(ahead);
  if (token.kind != TokenKind::kIdentifier) return false;
  switch (MeaningOf(token.name())) {
    case Meaning::kType: return true;
    case Meaning::kUnknown: break;
    default: return false;
  }
  const Word word = WordAt(ahead);
  return word == Word::kNumericType || word == Word::kObjectType || word == Word::kUnsigned;
}

}  // namespace clipc::ast
