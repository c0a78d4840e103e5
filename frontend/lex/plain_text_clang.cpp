// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/lex/plain_text_clang.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include <clang/Basic/IdentifierTable.h>
#include <clang/Lex/Lexer.h>
#include <clang/Lex/Preprocessor.h>
#include <clang/Lex/Token.h>

namespace clipc {
namespace {

using enum TokenKind;

// What begins with a letter.
enum class Letter : std::uint8_t { kOther, kSlash, kWord, kDigit, kSingle, kBrace, kOperator };

struct LetterInfo {
  Letter what = Letter::kOther;
  TokenKind kind = kUnknown;     // of the letter alone
  TokenKind twice = kUnknown;    // of two of it; kUnknown: they are left to Clang
  TokenKind assigns = kUnknown;  // with `=` after it
};

constexpr std::array<LetterInfo, 256> kLetters = [] {
  std::array<LetterInfo, 256> letters;
  const auto at = [&](char letter) -> LetterInfo& {
    return letters[static_cast<unsigned char>(letter)];
  };
  for (char c = '0'; c <= '9'; ++c) at(c).what = Letter::kDigit;
  for (char c = 'a'; c <= 'z'; ++c) at(c).what = Letter::kWord;
  for (char c = 'A'; c <= 'Z'; ++c) at(c).what = Letter::kWord;
  at('_').what = Letter::kWord;
  at('{') = {Letter::kBrace, kLeftBrace};
  at('}') = {Letter::kBrace, kRightBrace};
  at('(') = {Letter::kSingle, kLeftParen};
  at(')') = {Letter::kSingle, kRightParen};
  at('[') = {Letter::kSingle, kLeftBracket};
  at(']') = {Letter::kSingle, kRightBracket};
  at(';') = {Letter::kSingle, kSemicolon};
  at(',') = {Letter::kSingle, kComma};
  at('~') = {Letter::kSingle, kTilde};
  at('.') = {Letter::kOperator, kDot};
  at(':') = {Letter::kOperator, kColon};
  at('?') = {Letter::kOperator, kQuestion};
  at('=') = {Letter::kOperator, kEqual, kUnknown, kEqualEqual};
  at('<') = {Letter::kOperator, kLess, kUnknown, kLessEqual};
  at('>') = {Letter::kOperator, kGreater, kUnknown, kGreaterEqual};
  at('!') = {Letter::kOperator, kExclaim, kUnknown, kExclaimEqual};
  at('+') = {Letter::kOperator, kPlus, kPlusPlus, kPlusEqual};
  at('-') = {Letter::kOperator, kMinus, kMinusMinus, kMinusEqual};
  at('*') = {Letter::kOperator, kStar, kUnknown, kStarEqual};
  at('/') = {Letter::kSlash, kSlash, kUnknown, kSlashEqual};
  at('%') = {Letter::kOperator, kPercent, kUnknown, kPercentEqual};
  at('&') = {Letter::kOperator, kAmp, kAmpAmp, kAmpEqual};
  at('|') = {Letter::kOperator, kPipe, kPipePipe, kPipeEqual};
  at('^') = {Letter::kOperator, kCaret, kUnknown, kCaretEqual};
  return letters;
}();

const LetterInfo& InfoOf(char letter) { return kLetters[static_cast<unsigned char>(letter)]; }
constexpr std::array<bool, 256> kIsOfWord = [] {
  std::array<bool, 256> is_of_word{};
  for (std::size_t i = 0; i < kLetters.size(); ++i)
    is_of_word[i] = kLetters[i].what == Letter::kWord || kLetters[i].what == Letter::kDigit;
  return is_of_word;
}();
bool IsOfWord(char letter) { return kIsOfWord[static_cast<unsigned char>(letter)]; }
// Whether the letter after a word or a number makes something else of it: a string with a prefix,
// a longer name.
bool MayGoOn(char letter) {
  return letter == '"' || letter == '\'' || letter == '\\' || letter == '$' || (letter & 0x80) != 0;
}
bool IsOperator(char letter) {
  return InfoOf(letter).what == Letter::kOperator || letter == '/' || letter == '\\' ||
         letter == '#';
}

const char* Find(const char* begin, const char* end, char letter) {
  return static_cast<const char*>(
      std::memchr(begin, letter, static_cast<std::size_t>(end - begin)));
}

// The end of the line in which the comment at `at` stands; null if a backslash may make the comment
// longer.
const char* EndOfLineComment(const char* at, const char* end) {
  const char* const line_end = Find(at, end, '\n');
  if (!line_end) return nullptr;
  const char* last = line_end - 1;
  if (*last == '\r') --last;
  if (last > at && Find(at, last, '\r')) return nullptr;
  while (last > at && (*last == ' ' || *last == '\t' || *last == '\f' || *last == '\v')) --last;
  return *last == '\\' ? nullptr : line_end;
}

// The place after the comment at `at`; null if there is something in it that Clang warns about, or
// reads in another way.
const char* EndOfBlockComment(const char* at, const char* end) {
  const char* const open = at + 2;
  for (const char* slash = open; (slash = Find(slash, end, '/')); ++slash) {
    if (slash > open && slash[-1] == '*') return Find(open, slash, '\\') ? nullptr : slash + 1;
    if (slash + 1 < end && slash[1] == '*') return nullptr;
  }
  return nullptr;
}

}  // namespace

Name NameOf(clang::IdentifierInfo& identifier, Names& names) {
  auto known = reinterpret_cast<std::uintptr_t>(identifier.getFETokenInfo());
  if (known == 0) {
    const std::string_view text(identifier.getNameStart(), identifier.getLength());
    known = std::uintptr_t{names.Intern(text).index} + 1;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): Clang keeps the pointer and does not follow it.
    identifier.setFETokenInfo(reinterpret_cast<void*>(known));
  }
  return Name{static_cast<std::uint32_t>(known - 1)};
}

// Returns whether a token may begin at place.at.
inline bool PlainText::SkipSpace(Place& place) {
  const char* at = place.at;
  for (;;) {
    while (*at == ' ' || *at == '\t') ++at;
    if (*at == '\n' || *at == '\r') {
      place.line = ++at;
    } else if (at < place.limit && *at == '/' && (at[1] == '/' || at[1] == '*')) {
      const char* const after =
          at[1] == '/' ? EndOfLineComment(at, place.end) : EndOfBlockComment(at, place.end);
      if (!after) return false;
      at = after;
    } else {
      place.at = at;
      return at < place.limit;
    }
  }
}

void MacroNames::Add(std::string_view word) {
  char bytes[16] = {};
  std::memcpy(bytes, word.data(), std::min(word.size(), sizeof(bytes)));
  const WordHash hash(bytes, word.size());
  bits_[hash.bits >> 21] |= std::uint64_t{1} << (hash.bits >> 15 & 63);
}

inline Name PlainText::NameFor(std::string_view text, const WordHash& hash) {
  if (const std::uint16_t slot = slots_[hash.bits % kSlots]; slot != 0) {
    const Word& word = words_[slot - 1];
    if (word.letters[0] == hash.letters[0] && word.letters[1] == hash.letters[1] &&
        word.size == text.size() && (text.size() <= 16 || names_[word.name] == text))
      return word.name;
  }
  return Note(text, hash);
}

// Puts a word into the place of the one that has its slot.
Name PlainText::Note(std::string_view text, const WordHash& hash) {
  std::uint16_t& slot = slots_[hash.bits % kSlots];
  if (slot == 0) {
    words_.emplace_back();
    slot = static_cast<std::uint16_t>(words_.size());
  }
  const Name name = names_.Intern(text);
  words_[slot - 1] = {
      {hash.letters[0], hash.letters[1]}, static_cast<std::uint32_t>(text.size()), name};
  return name;
}

// Whether the preprocessor passes the word on as it is.
bool PlainText::IsPlain(std::string_view text) const {
  const clang::IdentifierInfo* const identifier =
      preprocessor_.getIdentifierInfo(llvm::StringRef(text.data(), text.size()));
  return identifier->getTokenID() == clang::tok::identifier &&
         !identifier->isHandleIdentifierCase();
}

inline bool PlainText::AddWord(Place& place, Token token) {
  const char* end = place.at + 1;
  while (IsOfWord(*end)) ++end;
  if (MayGoOn(*end)) return false;
  const std::string_view text(place.at, static_cast<std::size_t>(end - place.at));
  const WordHash hash(place.at, text.size());  // the file goes on for kReach bytes
  // Clang's own macros begin with `_`.
  if ((text[0] == '_' || macros_.MayHave(hash)) && !IsPlain(text)) return false;
  token.value = NameFor(text, hash).index;
  writer_.AddIdentifier(token, text);
  place.at = end;
  return true;
}

bool PlainText::AddNumber(Place& place, Token token) {
  const char* end = place.at + 1;
  for (;; ++end) {
    const bool is_sign = *end == '+' || *end == '-';
    const char before = static_cast<char>(end[-1] | 0x20);
    if (is_sign && before == 'p') return false;
    if (*end == '.' && InfoOf(end[1]).what == Letter::kWord) return false;  // Clang knows swizzles
    if (!IsOfWord(*end) && *end != '.' && !(is_sign && before == 'e')) break;
  }
  if (MayGoOn(*end)) return false;
  writer_.AddNumber(token, {place.at, static_cast<std::size_t>(end - place.at)});
  place.at = end;
  return true;
}

// Returns whether the token at place.at was added; it is left to Clang otherwise.
inline bool PlainText::AddToken(Place& place) {
  const LetterInfo& letter = InfoOf(*place.at);
  const char next = place.at[1];
  Token token;
  token.after_space = place.at != place.done;
  token.location = place.location + static_cast<std::uint32_t>(place.at - place.end);
  switch (letter.what) {
    case Letter::kWord: return AddWord(place, token);
    case Letter::kDigit: return AddNumber(place, token);
    case Letter::kBrace:
      if (!(letter.kind == kLeftBrace ? braces_.open : braces_.close)) return false;
      [[fallthrough]];
    case Letter::kSingle: token.kind = letter.kind; break;
    case Letter::kSlash:
    case Letter::kOperator:
      if (letter.kind == kDot && InfoOf(next).what == Letter::kDigit)
        return AddNumber(place, token);
      token.kind = letter.kind;
      if (!IsOperator(next)) break;
      // An operator of two letters, if no third may belong to it.
      token.kind = next == '=' ? letter.assigns : next == *place.at ? letter.twice : kUnknown;
      if (token.kind == kUnknown || IsOperator(place.at[2])) return false;
      ++place.at;
      break;
    default: return false;
  }
  ++place.at;
  writer_.AddPunctuator(token);
  return true;
}

void PlainText::SkipLines(clang::Lexer& lexer) {
  const llvm::StringRef text = lexer.getBuffer();
  const char* const begin = lexer.getBufferLocation();
  Place place{begin, begin, begin, text.end() - kReach, text.end(), 0};
  if (begin >= place.limit || (begin != text.begin() && begin[-1] != '\n')) return;
  SkipSpace(place);
  if (place.line > begin)
    lexer.seek(static_cast<unsigned>(place.line - text.begin()), /*IsAtStartOfLine=*/true);
}

std::size_t PlainText::AddAfter(const clang::Token& last, Braces braces) {
  braces_ = braces;
  auto* const lexer = static_cast<clang::Lexer*>(preprocessor_.getCurrentLexer());
  if (std::endian::native != std::endian::little || !lexer || last.isAnnotation() ||
      lexer->isPragmaLexer() || !lexer->getFileLoc().isFileID())
    return 0;
  const llvm::StringRef text = lexer->getBuffer();
  const char* const begin = lexer->getBufferLocation();
  Place place{begin, begin, begin, text.end() - kReach, text.end(), 0};
  place.location = lexer->getFileLoc().getRawEncoding() + static_cast<std::uint32_t>(text.size());
  const auto here = place.location + static_cast<std::uint32_t>(begin - place.end);
  if (begin >= place.limit || last.getLocation().getRawEncoding() + last.getLength() != here)
    return 0;
  std::size_t count = 0;
  while (SkipSpace(place) && AddToken(place)) {
    place.done = place.line = place.at;
    ++count;
  }
  // A token that is left to Clang has the white space before it, or the beginning of its line.
  if (place.line > begin)
    lexer->seek(static_cast<unsigned>(place.line - text.begin()), place.line > place.done);
  return count;
}

}  // namespace clipc
