// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace clipc::glsl {

// How tightly an expression binds, loosest first: section 5.1 of the GLSL specification.
enum class Binding : std::uint8_t {
  kComma, kAssignment, kConditional, kLogicalOr, kLogicalXor, kLogicalAnd, kBitOr, kBitXor, kBitAnd, kEquality,
  kRelational, kShift, kSum, kProduct, kUnary, kPostfix
};
constexpr Binding Tighter(Binding binding) {
  return binding == Binding::kPostfix ? binding : static_cast<Binding>(static_cast<int>(binding) + 1);
}

// A written expression.
struct Text {
  std::string text;
  Binding binding = Binding::kPostfix;

  // The text, in parentheses when it binds looser than its place needs.
  std::string At(Binding least) && {
    return binding >= least ? std::move(text) : "(" + text + ")";
  }
  std::string At(Binding least) const& { return binding >= least ? text : "(" + text + ")"; }
};

// `left op right`; the operators of GLSL associate to the left. Takes left's buffer, so that long chains stay linear.
inline Text Infix(Text left, std::string_view op, Text right, Binding binding) {
  std::string text = std::move(left).At(binding);
  text.reserve(text.size() + op.size() + right.text.size() + 4);
  text += ' ';
  text += op;
  text += ' ';
  text += std::move(right).At(Tighter(binding));
  return {std::move(text), binding};
}

// An argument of a call: everything but a comma may stand without parentheses.
inline std::string Argument(Text text) { return std::move(text).At(Binding::kAssignment); }

}  // namespace clipc::glsl
