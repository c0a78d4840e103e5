// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "frontend/lex/token_writer.h"

// For the *_clang.cpp files, which alone include Clang.
namespace clang {
class IdentifierInfo;
class Lexer;
class Preprocessor;
class Token;
}  // namespace clang

namespace clipc {

// The name of an identifier; its index plus one is kept with it, which saves looking it up again.
Name NameOf(clang::IdentifierInfo& identifier, Names& names);

// A word's hash, by its first sixteen letters.
struct WordHash {
  // `bytes` are sixteen that may be read, the word first.
  WordHash(const char* bytes, std::size_t size) {
    std::memcpy(letters, bytes, sizeof(letters));
    letters[0] = FirstBytes(letters[0], size);
    letters[1] = size <= 8 ? 0 : FirstBytes(letters[1], size - 8);
    const std::uint64_t mixed =
        (letters[0] ^ letters[1] * 0xC2B2AE3D27D4EB4Fu) * 0x9E3779B97F4A7C15u;
    bits = static_cast<std::uint32_t>(mixed >> 38) ^ static_cast<std::uint32_t>(size & 0xff);
  }

  std::uint64_t letters[2];  // padded with zeros
  std::uint32_t bits;        // 26 of them

 private:
  static std::uint64_t FirstBytes(std::uint64_t bytes, std::size_t count) {
    return count >= 8 ? bytes : bytes & ((std::uint64_t{1} << 8 * count) - 1);
  }
};

// The words that have been names of macros, and a few others.
class MacroNames {
 public:
  void Add(std::string_view word);
  bool MayHave(const WordHash& hash) const {
    return bits_[hash.bits >> 21] >> (hash.bits >> 15 & 63) & 1;
  }

 private:
  std::array<std::uint64_t, 32> bits_{};
};

// The text between what needs a preprocessor: words that are no macros, numbers, operators and
// plain comments, which are most of a shader. It is read here at a fifth of the cost. Everything
// else is left to Clang: directives, macros, strings, the braces at which LazyBodies stops, what a
// backslash or a further letter may change, and the last kReach bytes of a file.
class PlainText {
 public:
  // `macros` has the names of all that have been defined.
  PlainText(clang::Preprocessor& preprocessor, const MacroNames& macros, Names& names,
            TokenWriter& writer)
      : preprocessor_(preprocessor), macros_(macros), names_(names), writer_(writer) {
    words_.reserve(kSlots / 4);
  }

  // The braces that are read here.
  struct Braces {
    bool open = true, close = true;
  };

  // Adds the tokens that follow `last`, if that is the token that the lexer of a file has just
  // read, up to the first that is left to Clang, where the lexer goes on. Returns how many.
  std::size_t AddAfter(const clang::Token& last, Braces braces);

  // Passes over lines without tokens, if `lexer` is at the beginning of a line.
  static void SkipLines(clang::Lexer& lexer);

  // Nothing is read that is longer than this, or nearer to the end of a file.
  static constexpr std::ptrdiff_t kReach = 32;

 private:
  static constexpr std::size_t kSlots = 256;
  // A word that was read before.
  struct Word {
    std::uint64_t letters[2];
    std::uint32_t size;
    Name name;
  };

  struct Place {
    const char* at;
    const char* done;        // the end of the last token
    const char* line;        // after the last new line that no token follows yet, or `done`
    const char* limit;       // where nothing begins any more that is read here
    const char* end;         // of the text
    std::uint32_t location;  // of the end
  };
  // These are parts of AddAfter, which is a fifth of a compile where they are functions.
  [[gnu::always_inline]] static bool SkipSpace(Place& place);
  [[gnu::always_inline]] bool AddToken(Place& place);
  [[gnu::always_inline]] bool AddWord(Place& place, Token token);
  [[gnu::always_inline]] Name NameFor(std::string_view text, const WordHash& hash);

  bool AddNumber(Place& place, Token token);
  bool IsPlain(std::string_view text) const;
  Name Note(std::string_view text, const WordHash& hash);

  clang::Preprocessor& preprocessor_;
  const MacroNames& macros_;
  Names& names_;
  TokenWriter& writer_;
  Braces braces_;
  std::array<std::uint16_t, kSlots> slots_{};  // the number of a word, counted from 1
  std::vector<Word> words_;
};

}  // namespace clipc
