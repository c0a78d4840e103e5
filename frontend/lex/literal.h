// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "frontend/lex/token.h"

namespace clipc {

enum class NumberProblem : std::uint8_t {
  kNone,
  kNotANumber,  // no digits, or letters that are no suffix
  kBadOctal,    // 089
  kTooLarge,    // an integer beyond 64 bits
  kInfinite,    // a floating-point number beyond its type's range: the value is infinity
};

// A number read from the start of a text.
struct Number {
  LiteralKind kind = LiteralKind::kInt;
  std::uint64_t value = 0;  // as Token::value
  std::size_t length = 0;   // characters used; what follows is not part of the number
  NumberProblem problem = NumberProblem::kNone;
};

// Reads the number at the start of `text`, which begins with a digit, or with `.` and a digit, and
// has no line continuations in it. Decimal, octal (0..), hexadecimal; suffixes u l ul ll ull, f h l
// in either case. Without a suffix an integer that needs the 32nd bit is a uint (fxc: 0xFFFFFFFF is
// 4294967295), a longer one an int64; a floating-point number is a float whose value keeps a
// double's precision until it is used.
//
// Stops where a swizzle starts (`1.0.yyy`) or where C's lexer would take in an operator (`0x1e+2`),
// so `length` may be less than the text's.
Number ReadNumber(std::string_view text);

// The value behind Microsoft's spelling of the special numbers, `1.#INF`, `1.#IND`, `1.#QNAN`,
// `1.#SNAN`, given the identifier after `#`. False if it is none of them.
bool ReadSpecialNumber(std::string_view identifier, Number& number);

// Appends what a string literal's source text stands for, without its quotes. An unknown escape
// stands for its letter.
void AppendUnescaped(std::string_view literal, std::string& out);

// The value of 'a' or 'abcd', quotes included: the characters as bytes of an int, the last one
// lowest.
std::uint32_t CharacterValue(std::string_view literal);

}  // namespace clipc
