// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
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

// Appends the parts, none of which lies in `text`. Memory is asked for once.
void AppendAll(std::string& text, std::initializer_list<std::string_view> parts);
template <typename... Parts>
void Append(std::string& text, const Parts&... parts) {
  AppendAll(text, {std::string_view(parts)...});
}
template <typename... Parts>
std::string Concat(const Parts&... parts) {
  std::string text;
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
  // Appends the text as At(least) returns it.
  void AppendTo(std::string& place, Binding least) const {
    binding >= least ? Append(place, text) : Append(place, "(", text, ")");
  }
};

// Returns `left op right`; the operators of GLSL associate to the left. The result takes over
// left's buffer, so that long chains stay linear.
inline Text Infix(Text left, std::string_view op, const Text& right, Binding binding) {
  std::string text = std::move(left).At(binding);
  Append(text, " ", op, " ");
  right.AppendTo(text, Tighter(binding));
  return {std::move(text), binding};
}

// Returns the text as an argument of a call: only a comma needs parentheses.
inline std::string Argument(Text text) { return std::move(text).At(Binding::kAssignment); }

// Returns the call function(a, b, c); one argument may be the whole list.
inline Text Called(std::string_view function, std::initializer_list<std::string_view> arguments) {
  if (arguments.size() == 1) return {Concat(function, "(", *arguments.begin(), ")")};
  return {Concat(function, "(", ListOf(arguments, std::identity()), ")")};
}

}  // namespace clipc::glsl
