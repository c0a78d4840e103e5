// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/json_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

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

void JsonWriter::Begin() {
  if (depth_ != 0) End(NewLine(0));
}

// Most of a document is keys.
void JsonWriter::Begin(JsonKey key) {
  const std::size_t size = key.text.size();
  char* to = NewLine(size + 4);
  *to++ = '"';
  std::memcpy(to, key.text.data(), size);
  to += size;
  *to++ = '"', *to++ = ':', *to++ = ' ';
  End(to);
}

char* JsonWriter::NewLine(std::size_t count) {
  constexpr std::string_view kLine = ",\n                               ";
  constexpr std::size_t kCopied = kLine.size() - 1;  // with the comma or without
  const std::size_t skipped = is_empty_ ? 1 : 0, indent = 2 * depth_;
  is_empty_ = false;
  char* to = Room(kCopied + indent + count);
  std::memcpy(to, kLine.data() + skipped, kCopied);
  to += 2 - skipped;
  if (indent > kCopied - 2) std::memset(to, ' ', indent);
  return to + indent;
}

void JsonWriter::Grow(std::size_t count) {
  room_ = 2 * room_ + count;
  auto grown = std::make_unique_for_overwrite<char[]>(room_);
  std::memcpy(grown.get(), text_.get(), size_);
  text_ = std::move(grown);
}

void JsonWriter::Append(std::int64_t number) {
  constexpr std::size_t kMostDigits = 24;
  char* to = Room(kMostDigits);
  End(std::to_chars(to, to + kMostDigits, number).ptr);
}

void JsonWriter::Append(float number) {
  if (!std::isfinite(number)) return Put("null");
  constexpr std::size_t kMostDigits = 24;
  char* to = Room(kMostDigits);
  End(std::to_chars(to, to + kMostDigits, number).ptr);
}

void JsonWriter::Append(std::string_view text) {
  char* to = Room(text.size() + 2);
  *to++ = '"';
  std::size_t plain = 0;
  for (; plain < text.size() && IsPlain(text[plain]); ++plain) *to++ = text[plain];
  End(to);
  if (plain < text.size()) AppendEscaped(text.substr(plain));
  Put('"');
}

void JsonWriter::AppendEscaped(std::string_view text) {
  constexpr std::string_view kNamed = "\"\\\b\f\n\r\t";
  constexpr std::string_view kNames = "\"\\bfnrt";
  while (!text.empty()) {
    Character character{1, true};
    if (const std::size_t named = kNamed.find(text[0]); named != std::string_view::npos) {
      Put('\\');
      Put(kNames[named]);
    } else if (IsPlain(text[0])) {
      Put(text[0]);
    } else if (static_cast<unsigned char>(text[0]) < 0x80) {
      Put(fmt::format("\\u{:04x}", static_cast<unsigned char>(text[0])));
    } else {
      character = CharacterAt(text);
      Put(character.is_valid ? text.substr(0, character.length) : "\xEF\xBF\xBD");
    }
    text.remove_prefix(character.length);
  }
}

}  // namespace clipc
