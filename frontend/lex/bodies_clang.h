// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <clang/Basic/SourceLocation.h>
#include <clang/Lex/Token.h>

#include "base/kept_blocks.h"
#include "frontend/lex/function_heads.h"
#include "frontend/lex/token.h"

namespace clang {
class Preprocessor;
class SourceManager;
}  // namespace clang

namespace clipc {

// The bodies of functions, which are read where a function is reached. While a file is read, the
// bodies are passed over as text; then those are read, each in its place, whose name is a word
// outside of bodies or of a body that is read.
class LazyBodies {
 public:
  // `functions` are the names of those that are reached from outside.
  LazyBodies(Tokens& tokens, const std::vector<std::string>& functions);
  ~LazyBodies();

  // Watches the macros of `preprocessor`. Call it before the first token.
  void Watch(clang::Preprocessor& preprocessor);

  // Looks at the token that was added last. The preprocessor goes on after the body that begins
  // there.
  void After(const clang::Token& token, clang::Preprocessor& preprocessor) {
    if (token.is(clang::tok::l_brace)) AfterBrace(token, preprocessor);
  }

  // Whether `token` ends one of the bodies that are read after the main file.
  bool IsEnd(const clang::Token& token) { return is_reading_ && IsEndOfBody(token); }

  // Ends the main file or a body at `token`, which has been added if it is a `}`. Returns whether a
  // further body is reached: it is what the preprocessor goes on with.
  bool GoOn(const clang::Token& token, clang::Preprocessor& preprocessor);

  // Whether all bodies were read as they would have been in their places: no macro in one has been
  // changed since.
  bool are_right() const { return are_right_; }
  // The names of the functions whose bodies were read afterwards, each as often as there are such.
  std::vector<std::string> ReachedFunctions() const;

  // Whether such bodies are being read: files are entered that have been read before.
  bool is_reading() const { return is_reading_; }

  // Whether IsEnd must see what follows `token`: it may end the body that is being read, or a word
  // after it may have been changed.
  bool asks_after(const clang::Token& token) const {
    return is_reading_ && (asks_each_word_ || token.is(clang::tok::r_brace));
  }

  // Puts each body that was read into its place.
  void Merge();

 private:
  class Macros;
  struct NameNews {
    std::size_t last_body = 0;  // as Body::before
    bool is_reached = false;
  };
  struct Body {
    std::size_t place;  // in the tokens
    clang::FileID file;
    std::size_t begin, end;  // in the file
    std::size_t changes;     // of macros before it
    std::size_t before;      // the body before it of that name, counted from 1; 0: there is none
    Name function;
    std::size_t first_token = 0, last_token = 0;
    bool is_reached = false;
  };

  NameNews& NewsOf(Name name) {
    if (name.index >= names_.size()) names_.resize(tokens_.names.size() + 64);
    return names_[name.index];
  }
  void Reach(Name name) {
    NameNews& news = NewsOf(name);
    if (!news.is_reached) ReachFirst(news);
  }
  void ReachFirst(NameNews& news);
  // Reads what has been added since the last call. Returns what FunctionHeads::Next does for the
  // last token.
  Name CatchUp();
  void AfterBrace(const clang::Token& token, clang::Preprocessor& preprocessor);
  bool IsEndOfBody(const clang::Token& token);
  void Begin(Body& body, clang::Preprocessor& preprocessor);

  Tokens& tokens_;
  FunctionHeads heads_;
  std::size_t seen_ = 0;  // of the tokens
  KeptVector<Body> bodies_;
  KeptVector<NameNews> names_;    // by the index of the name
  KeptVector<std::size_t> work_;  // bodies that are reached and not read
  std::size_t outside_ = 0;       // the number of tokens outside of these bodies
  Macros* macros_ = nullptr;
  Body* reading_ = nullptr;    // after the main file
  clang::SourceLocation end_;  // of that body
  bool is_reading_ = false, asks_each_word_ = false, are_right_ = true;
};

}  // namespace clipc
