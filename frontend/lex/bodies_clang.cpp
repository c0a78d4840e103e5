// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/lex/bodies_clang.h"

#include <algorithm>
#include <span>
#include <utility>

#include <clang/Basic/IdentifierTable.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Lex/Lexer.h>
#include <clang/Lex/MacroInfo.h>
#include <clang/Lex/PPCallbacks.h>
#include <clang/Lex/Preprocessor.h>
#include <clang/Lex/Token.h>
#include <llvm/ADT/DenseMap.h>

namespace clipc {
namespace {

namespace tok = clang::tok;

// Whether the brackets of a macro's text match.
bool HasMatchingBrackets(const clang::MacroInfo& macro) {
  int braces = 0, others = 0;
  for (const clang::Token& token : macro.tokens()) {
    if (token.isOneOf(tok::l_brace, tok::r_brace)) braces += token.is(tok::l_brace) ? 1 : -1;
    if (token.isOneOf(tok::l_paren, tok::l_square)) ++others;
    if (token.isOneOf(tok::r_paren, tok::r_square)) --others;
  }
  return braces == 0 && others == 0;
}

}  // namespace

// What has become of the macros since a body was passed over.
class LazyBodies::Macros : public clang::PPCallbacks {
 public:
  void MacroDefined(const clang::Token& name, const clang::MacroDirective* directive) override {
    Change(name);
    if (!HasMatchingBrackets(*directive->getMacroInfo())) all_match_ = false;
  }
  void MacroUndefined(const clang::Token& name, const clang::MacroDefinition&,
                      const clang::MacroDirective*) override {
    Change(name);
  }
  void MacroExpands(const clang::Token& name, const clang::MacroDefinition& macro,
                    clang::SourceRange, const clang::MacroArgs*) override {
    Use(name.getIdentifierInfo());
    // __COUNTER__ counts in the order of reading.
    if (macro.getMacroInfo()->isBuiltinMacro()) is_changed_ = true;
  }

  // From here on changes count: a body was passed over.
  void Track() { is_tracking_ = true; }
  // Begins to read a body that was passed over after so many changes.
  void Begin(std::size_t changes) {
    begin_ = changes;
    is_changed_ = false;
  }
  // Whether any have been changed since that body.
  bool are_changed() const { return begin_ < changes_; }
  void Use(const clang::IdentifierInfo* word) {
    if (word && are_changed() && last_.lookup(word) > begin_) is_changed_ = true;
  }
  // Whether a word of the body that is being read means something else by now.
  bool is_changed() const { return is_changed_; }

  bool all_match() const { return all_match_; }
  std::size_t changes() const { return changes_; }

 private:
  void Change(const clang::Token& name) {
    ++changes_;
    if (is_tracking_) last_[name.getIdentifierInfo()] = changes_;
  }

  llvm::DenseMap<const clang::IdentifierInfo*, std::size_t> last_;
  std::size_t changes_ = 0, begin_ = 0;
  bool is_tracking_ = false, all_match_ = true, is_changed_ = false;
};

LazyBodies::LazyBodies(Tokens& tokens, const std::vector<std::string>& functions)
    : tokens_(tokens), heads_(tokens.names) {
  for (std::string_view name : functions) {
    while (!name.empty()) {  // A::B
      const std::size_t end = std::min(name.find(':'), name.size());
      Reach(tokens.names.Intern(name.substr(0, end)));
      name.remove_prefix(std::min(name.find_first_not_of(':', end), name.size()));
    }
  }
}
LazyBodies::~LazyBodies() = default;

void LazyBodies::Watch(clang::Preprocessor& preprocessor) {
  auto macros = std::make_unique<Macros>();
  macros_ = macros.get();
  preprocessor.addPPCallbacks(std::move(macros));
}

Name LazyBodies::CatchUp() {
  names_.resize(std::max<std::size_t>(names_.size(), tokens_.names.size()));
  const auto use = [&](Name word) {
    if (names_[word.index].is_reached) return;
    ReachFirst(names_[word.index]);
    // The string "A::B" of an attribute names the function B.
    const std::string_view text = tokens_.names[word];
    if (const std::size_t colon = text.rfind(':'); colon != text.npos)
      Reach(tokens_.names.Intern(text.substr(colon + 1)));
  };
  Name opened;
  while (seen_ < tokens_.list.size()) {
    if (heads_.is_inside()) {
      seen_ += heads_.NextInside(std::span(tokens_.list).subspan(seen_), use);
      if (seen_ == tokens_.list.size()) return Name();
    }
    opened = heads_.Next(tokens_.list[seen_++], use);
  }
  return opened;
}

void LazyBodies::AfterBrace(const clang::Token& token, clang::Preprocessor& preprocessor) {
  if (is_reading_) return;
  const Name function = CatchUp();
  // What is reached already is read where it is.
  if (!function || NewsOf(function).is_reached) return;
  if (token.getLocation().isMacroID() || !macros_->all_match()) return;
  auto* lexer = static_cast<clang::Lexer*>(preprocessor.getCurrentLexer());
  if (!lexer) return;
  const auto [file, offset] = preprocessor.getSourceManager().getDecomposedLoc(token.getLocation());
  if (file != lexer->getFileID()) return;
  const llvm::StringRef text = lexer->getBuffer();
  const auto end = EndOfBody({text.data(), text.size()}, offset + 1);
  if (!end) return;
  bodies_.push_back({tokens_.list.size(), file, offset + 1, *end, macros_->changes(),
                     std::exchange(NewsOf(function).last_body, bodies_.size() + 1), function});
  macros_->Track();
  lexer->seek(static_cast<unsigned>(*end), /*IsAtStartOfLine=*/false);
}

void LazyBodies::ReachFirst(NameNews& news) {
  news.is_reached = true;
  for (std::size_t body = news.last_body; body != 0; body = bodies_[body - 1].before)
    work_.push_back(body - 1);
}

bool LazyBodies::IsEndOfBody(const clang::Token& token) {
  if (token.getLocation() == end_) return true;
  if (macros_->are_changed()) macros_->Use(token.getIdentifierInfo());
  return false;
}

bool LazyBodies::GoOn(const clang::Token& token, clang::Preprocessor& preprocessor) {
  const clang::FileID main = preprocessor.getSourceManager().getMainFileID();
  if (!std::exchange(is_reading_, true)) {
    if (!bodies_.empty()) CatchUp();
    outside_ = tokens_.list.size();
    // The main file lies under all others that are entered.
    if (!work_.empty()) preprocessor.EnterSourceFile(main, nullptr, clang::SourceLocation());
  } else {
    if (token.is(tok::eof)) return are_right_ = is_reading_ = false;
    tokens_.list.pop_back();  // it has made complete what stands before it
    reading_->last_token = tokens_.list.size();
    are_right_ = are_right_ && !macros_->is_changed();
    if (reading_->file != main) preprocessor.RemoveTopOfLexerStack();
    for (std::size_t i = reading_->first_token; i < reading_->last_token; ++i) {
      const Token& word = tokens_.list[i];
      if (word.kind == TokenKind::kIdentifier) Reach(word.name());
    }
  }
  is_reading_ = !work_.empty();
  if (!is_reading_) return false;
  reading_ = &bodies_[work_.back()];
  work_.pop_back();
  if (reading_->file != main)
    preprocessor.EnterSourceFile(reading_->file, nullptr, clang::SourceLocation());
  Begin(*reading_, preprocessor);
  return true;
}

void LazyBodies::Begin(Body& body, clang::Preprocessor& preprocessor) {
  static_cast<clang::Lexer*>(preprocessor.getCurrentLexer())
      ->seek(static_cast<unsigned>(body.begin), /*IsAtStartOfLine=*/false);
  end_ = preprocessor.getSourceManager().getComposedLoc(body.file, static_cast<unsigned>(body.end));
  macros_->Begin(body.changes);
  asks_each_word_ = macros_->are_changed();
  body.first_token = tokens_.list.size();
  body.is_reached = true;
}

std::vector<std::string> LazyBodies::ReachedFunctions() const {
  std::vector<std::string> names;
  for (const Body& body : bodies_) {
    if (body.is_reached) names.emplace_back(tokens_.names[body.function]);
  }
  return names;
}

void LazyBodies::Merge() {
  if (tokens_.list.size() == outside_) return;
  KeptVector<Token> merged;
  merged.reserve(tokens_.list.size());
  const auto at = [&](std::size_t index) {
    return tokens_.list.begin() + static_cast<std::ptrdiff_t>(index);
  };
  std::size_t done = 0;
  for (const Body& body : bodies_) {
    if (!body.is_reached) continue;
    merged.insert(merged.end(), at(done), at(body.place));
    merged.insert(merged.end(), at(body.first_token), at(body.last_token));
    done = body.place;
  }
  merged.insert(merged.end(), at(done), at(outside_));
  tokens_.list = std::move(merged);
}

}  // namespace clipc
