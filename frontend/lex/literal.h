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
  kNotANumber,  // no digits, or letters that are not a suffix
  kBadOctal,    // 089
  kTooLarge,    // an integer beyond 64 bits
  kInfinite,    // a floating-point number beyond the range of its type; its value is infinity, but
                // that of a number without a suffix is the double
};

// A number read from the start of a text.
struct Number {
  LiteralKind kind = LiteralKind::kInt;
  std::uint64_t value = 0;  // encoded as in Token::value
  std::size_t length = 0;   // the characters that are part of the number
  NumberProblem problem = NumberProblem::kNone;
  bool is_binary = false;  // 0b101, which is a number from shader model 6 on
};

// Reads the number at the start of `text`, which begins with a digit, or with `.` and a digit, and
// has no line continuations in it. Decimal, octal (0..), hexadecimal, binary (0b..); suffixes u l
// ul ll ull, f h l in either case. Without `ll` an integer is one of 32 bits, though its value may
// be longer; one beyond an int64 is a uint64. A hexadecimal one without a suffix is kHexadecimal. A
// floating-point number without a suffix is a float whose value keeps the precision of a double
// until it is used.
//
// A number ends where a swizzle starts (`1.0.yyy`), and at an operator that C's lexer makes part of
// a number (`0x1e+2`).
Number ReadNumber(std::string_view text);

// Reads the identifier after `#` in Microsoft's spellings of the special numbers: `1.#INF`,
// `1.#IND`, `1.#QNAN`, `1.#SNAN`. Returns false if it is not one of them.
bool ReadSpecialNumber(std::string_view identifier, Number& number);

// Appends the characters that a string literal, given with its quotes, stands for. An unknown
// escape stands for its letter.
void AppendUnescaped(std::string_view literal, std::string& out);

// The value of 'a' or 'abcd', given with the quotes: the characters are the bytes of an int, the
// last one the lowest.
std::uint32_t CharacterValue(std::string_view literal);

}  // namespace clipc
