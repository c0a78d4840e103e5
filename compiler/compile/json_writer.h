// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace clipc {

// Prints a JSON document from its beginning to its end, two blanks for each level, and holds
// nothing but the text. A `body` prints the members of an object, or the elements of a list. Texts
// may have any bytes: those that are not UTF-8 become U+FFFD.
class JsonWriter {
 public:
  JsonWriter() { text_.reserve(kUsualSize); }

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
      text_ += "null";
    }
  }

  void Object(std::string_view key, auto&& body) {
    Key(key);
    Enclose('{', '}', body);
  }
  void List(std::string_view key, auto&& body) {
    Key(key);
    Enclose('[', ']', body);
  }
  // A list with an object for each item, whose members `print` prints.
  void ListOf(std::string_view key, const auto& items, auto&& print) {
    List(key, [&] {
      for (const auto& item : items) Object([&] { print(item); });
    });
  }
  void Member(std::string_view key, std::string_view text) {
    Key(key);
    Append(text);
  }
  void Member(std::string_view key, std::same_as<bool> auto value) {
    Key(key);
    text_ += value ? "true" : "false";
  }
  template <std::integral Number>
    requires(!std::same_as<Number, bool>)
  void Member(std::string_view key, Number number) {
    Key(key);
    Append(static_cast<std::int64_t>(number));
  }
  void Member(std::string_view key, std::same_as<float> auto number) {
    Key(key);
    Append(number);
  }
  void Null(std::string_view key) {
    Key(key);
    text_ += "null";
  }

  // The document, with a line feed at its end.
  std::string Finish() && { return std::move(text_) + "\n"; }

 private:
  static constexpr std::size_t kUsualSize = 8192;

  void Enclose(char open, char close, auto& body) {
    text_ += open;
    ++depth_;
    is_empty_ = true;
    body();
    --depth_;
    if (!is_empty_) NewLine();
    is_empty_ = false;
    text_ += close;
  }
  void NewLine();
  void Begin();  // a member or an element, after those before it
  void Key(std::string_view key);
  void Append(std::string_view text);
  void Append(std::int64_t number);
  void Append(float number);  // `null` unless it is finite
  void AppendEscaped(std::string_view text);

  std::string text_;
  std::size_t depth_ = 0;
  bool is_empty_ = true;  // nothing is in the innermost object or list yet
};

}  // namespace clipc
