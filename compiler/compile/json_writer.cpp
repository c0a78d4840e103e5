// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/json_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace clipc {
namespace {

// Whether a byte stands for itself in a JSON text.
constexpr std::array<bool, 256> kIsPlain = [] {
  std::array<bool, 256> plain{};
  for (std::size_t byte = 0x20; byte < 0x80; ++byte) plain[byte] = byte != '"' && byte != '\\';
  return plain;
}();
bool IsPlain(char c) { return kIsPlain[static_cast<unsigned char>(c)]; }

// The bytes that a character of several bytes begins with, as table 3-7 of the Unicode standard
// lists them: its length, and what its second byte is.
struct Lead {
  unsigned char first, last;
  std::size_t length;
  unsigned char second_first = 0x80, second_last = 0xBF;
};
constexpr Lead kLeads[] = {
    {0xC2, 0xDF, 2}, {0xE0, 0xE0, 3, 0xA0}, {0xE1, 0xEC, 3}, {0xED, 0xED, 3, 0x80, 0x9F},
    {0xEE, 0xEF, 3}, {0xF0, 0xF0, 4, 0x90}, {0xF1, 0xF3, 4}, {0xF4, 0xF4, 4, 0x80, 0x8F}};

// The character at the start of `text`, whose first byte is not ASCII.
struct Character {
  std::size_t length = 1;  // of a wrong one: of the bytes that could begin a character
  bool is_valid = false;
};
Character CharacterAt(std::string_view text) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  const auto lead = std::ranges::find_if(
      kLeads, [&](const Lead& row) { return byte(0) >= row.first && byte(0) <= row.last; });
  if (lead == std::end(kLeads)) return {};
  std::size_t length = 1;
  for (; length < lead->length && length < text.size(); ++length) {
    const unsigned char first = length == 1 ? lead->second_first : 0x80;
    const unsigned char last = length == 1 ? lead->second_last : 0xBF;
    if (byte(length) < first || byte(length) > last) break;
  }
  return {length, length == lead->length};
}

}  // namespace

void JsonWriter::NewLine() {
  text_ += '\n';
  text_.append(2 * depth_, ' ');
}

void JsonWriter::Begin() {
  if (depth_ == 0) return;
  if (!is_empty_) text_ += ',';
  is_empty_ = false;
  NewLine();
}

// Most of a document is keys, so what is around one is put there at once.
void JsonWriter::Key(std::string_view key) {
  constexpr std::string_view kSpaces = ",\n                          \"";
  const std::size_t indent = 2 * depth_;
  if (indent + 3 > kSpaces.size() || !std::ranges::all_of(key, IsPlain)) {
    Begin();
    Append(key);
    text_ += ": ";
    return;
  }
  const std::size_t begin = text_.size();
  const std::size_t first = is_empty_ ? 1 : 0;
  text_.resize(begin + 2 - first + indent + key.size() + 4);
  char* to = text_.data() + begin;
  to = std::copy_n(kSpaces.data() + first, 2 - first + indent, to);
  *to++ = '"';
  to = std::ranges::copy(key, to).out;
  std::ranges::copy(std::string_view("\": "), to);
  is_empty_ = false;
}

void JsonWriter::Append(std::int64_t number) {
  std::array<char, 24> digits;
  text_.append(digits.data(),
               std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

void JsonWriter::Append(float number) {
  if (!std::isfinite(number)) {
    text_ += "null";
    return;
  }
  std::array<char, 24> digits;
  text_.append(digits.data(),
               std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

void JsonWriter::Append(std::string_view text) {
  text_ += '"';
  if (std::ranges::all_of(text, IsPlain)) {
    text_ += text;
  } else {
    AppendEscaped(text);
  }
  text_ += '"';
}

void JsonWriter::AppendEscaped(std::string_view text) {
  constexpr std::string_view kNamed = "\"\\\b\f\n\r\t";
  constexpr std::string_view kNames = "\"\\bfnrt";
  while (!text.empty()) {
    Character character{1, true};
    if (const std::size_t named = kNamed.find(text[0]); named != std::string_view::npos) {
      text_ += '\\';
      text_ += kNames[named];
    } else if (IsPlain(text[0])) {
      text_ += text[0];
    } else if (static_cast<unsigned char>(text[0]) < 0x80) {
      text_ += fmt::format("\\u{:04x}", static_cast<unsigned char>(text[0]));
    } else {
      character = CharacterAt(text);
      text_ += character.is_valid ? text.substr(0, character.length) : "\xEF\xBF\xBD";
    }
    text.remove_prefix(character.length);
  }
}

}  // namespace clipc
