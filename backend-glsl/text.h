// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>

namespace clipc::glsl {

// The tightness with which an expression binds, loosest first: section 5.1 of the GLSL
// specification.
enum class Binding : std::uint8_t {
  kComma,
  kAssignment,
  kConditional,
  kLogicalOr,
  kLogicalXor,
  kLogicalAnd,
  kBitOr,
  kBitXor,
  kBitAnd,
  kEquality,
  kRelational,
  kShift,
  kSum,
  kProduct,
  kMinus,  // a unary operator that begins with `-`: after another `-` it would be a decrement
  kUnary,
  kPostfix
};
constexpr Binding Tighter(Binding binding) {
  return binding == Binding::kPostfix ? binding
                                      : static_cast<Binding>(static_cast<int>(binding) + 1);
}

inline void AppendPart(std::string& text, std::string_view part) { text.append(part); }
template <std::size_t kSize>
void AppendPart(std::string& text, const char (&part)[kSize]) {
  if constexpr (kSize == 2)
    text.push_back(part[0]);
  else
    text.append(part, kSize - 1);
}
template <std::same_as<std::uint32_t> Number>
void AppendPart(std::string& text, Number number) {
  char digits[10];
  text.append(digits, std::to_chars(digits, std::end(digits), number).ptr);
}
// Appends the parts, none of which lies in `text`. A part that is not a text has an AppendPart of
// its own.
template <typename... Parts>
void Append(std::string& text, const Parts&... parts) {
  (AppendPart(text, parts), ...);
}
// Returns the parts in one text, for which memory is asked for at most once.
template <typename... Parts>
std::string Concat(const Parts&... parts) {
  std::string text;
  const std::size_t size = (std::string_view(parts).size() + ...);
  if (size > text.capacity()) text.reserve(size);
  Append(text, parts...);
  return text;
}

// Returns the list "a, b, c" of text(part) for each part of a range, or of text(i) for each number
// below `parts`.
template <typename Parts, typename Each>
std::string ListOf(const Parts& parts, Each&& text) {
  if constexpr (std::integral<Parts>) {
    return ListOf(std::views::iota(Parts{0}, parts), text);
  } else {
    std::string list;
    std::string_view separator;
    for (const auto& part : parts) {
      Append(list, separator, text(part));
      separator = ", ";
    }
    return list;
  }
}

// A written expression.
struct Text {
  std::string text;
  Binding binding = Binding::kPostfix;

  // Returns the text, in parentheses if it binds looser than `least`.
  std::string At(Binding least) && {
    if (binding >= least) return std::move(text);
    return Concat("(", text, ")");
  }
};

// Returns the call function(a, b, c); one argument may be the whole list.
inline Text Called(std::string_view function, std::initializer_list<std::string_view> arguments) {
  if (arguments.size() == 1) return {Concat(function, "(", *arguments.begin(), ")")};
  return {Concat(function, "(", ListOf(arguments, std::identity()), ")")};
}

}  // namespace clipc::glsl
