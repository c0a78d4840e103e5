// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace clipc {

// A key of a JSON document, which has no byte to escape: a literal that has one does not compile.
struct JsonKey {
  consteval JsonKey(const char* literal) : text(literal) {
    for (const char c : text)
      if (c < ' ' || c > '~' || c == '"' || c == '\\') throw "a key has no byte to escape";
  }
  explicit JsonKey(std::string_view word) : text(word) {}

  std::string_view text;
};

// Prints a JSON document from its beginning to its end, two blanks for each level, and holds
// nothing but the text. A `body` prints the members of an object, or the elements of a list. Texts
// may have any bytes: those that are not UTF-8 become U+FFFD.
class JsonWriter {
 public:
  // The whole document, or an element of a list.
  void Object(auto&& body) {
    Begin();
    Enclose('{', '}', body);
  }
  void Text(std::string_view text) {
    Begin();
    Append(text);
  }

  // An element of a list: a number, or `null`.
  void NumberOrNull(std::optional<std::size_t> number) {
    Begin();
    if (number) {
      Append(static_cast<std::int64_t>(*number));
    } else {
      Put("null");
    }
  }

  void Object(JsonKey key, auto&& body) {
    Begin(key);
    Enclose('{', '}', body);
  }
  void List(JsonKey key, auto&& body) {
    Begin(key);
    Enclose('[', ']', body);
  }
  // A list with an object for each item, whose members `print` prints.
  void ListOf(JsonKey key, const auto& items, auto&& print) {
    List(key, [&] {
      for (const auto& item : items) Object([&] { print(item); });
    });
  }
  void Member(JsonKey key, std::string_view text) {
    Begin(key);
    Append(text);
  }
  void Member(JsonKey key, std::same_as<bool> auto value) {
    Begin(key);
    Put(value ? "true" : "false");
  }
  template <std::integral Number>
    requires(!std::same_as<Number, bool>)
  void Member(JsonKey key, Number number) {
    Begin(key);
    Append(static_cast<std::int64_t>(number));
  }
  void Member(JsonKey key, std::same_as<float> auto number) {
    Begin(key);
    Append(number);
  }
  void Null(JsonKey key) {
    Begin(key);
    Put("null");
  }

  // The document, with a line feed at its end.
  std::string Finish() && {
    Put('\n');
    return {text_.get(), size_};
  }

 private:
  static constexpr std::size_t kUsualSize = 8192;

  void Enclose(char open, char close, auto& body) {
    Put(open);
    ++depth_;
    is_empty_ = true;
    body();
    --depth_;
    if (!std::exchange(is_empty_, true)) End(NewLine(0));
    is_empty_ = false;
    Put(close);
  }
  // Each of these begins a line for a member or an element, after those before it.
  void Begin();
  void Begin(JsonKey key);
  // Begins a line, and returns its end, which has room for so many more bytes.
  char* NewLine(std::size_t count);
  void Append(std::string_view text);
  void Append(std::int64_t number);
  void Append(float number);  // `null` unless it is finite
  void AppendEscaped(std::string_view text);
  // The end of the text, which has room for so many more bytes.
  char* Room(std::size_t count) {
    if (room_ - size_ < count) Grow(count);
    return text_.get() + size_;
  }
  void Grow(std::size_t count);
  void End(const char* end) { size_ = static_cast<std::size_t>(end - text_.get()); }
  void Put(char c) {
    *Room(1) = c;
    ++size_;
  }
  void Put(std::string_view text) {
    std::memcpy(Room(text.size()), text.data(), text.size());
    size_ += text.size();
  }

  std::unique_ptr<char[]> text_ = std::make_unique_for_overwrite<char[]>(kUsualSize);
  std::size_t room_ = kUsualSize, size_ = 0;  // the bytes of `text_`, and those that are printed
  std::size_t depth_ = 0;
  bool is_empty_ = true;  // nothing is in the innermost object or list yet
};

}  // namespace clipc
