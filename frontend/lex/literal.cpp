// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/lex/literal.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <system_error>

#include "base/spelling.h"

namespace clipc {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsBinaryDigit(char c) { return c == '0' || c == '1'; }
bool IsHexDigit(char c) { return IsDigit(c) || (ToLower(c) >= 'a' && ToLower(c) <= 'f'); }
bool IsWordChar(char c) {
  return IsDigit(c) || (ToLower(c) >= 'a' && ToLower(c) <= 'z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

char At(std::string_view text, std::size_t i) { return i < text.size() ? text[i] : '\0'; }

// Reads one of the suffixes u l ul lu ll ull llu. `l` alone means 32 bits, as in fxc and C.
bool ReadIntegerSuffix(std::string_view text, Number& number) {
  bool is_unsigned = false;
  int longs = 0;
  for (; IsWordChar(At(text, number.length)); ++number.length) {
    const char c = ToLower(text[number.length]);
    if (c == 'u' && !is_unsigned) {
      is_unsigned = true;
    } else if (c == 'l' && longs < 2 && (longs == 0 || ToLower(text[number.length - 1]) == 'l')) {
      ++longs;
    } else {
      return false;
    }
  }
  const bool needs_top_bit = number.value > std::numeric_limits<std::int64_t>::max();
  if (longs == 2 || needs_top_bit) {
    number.kind = is_unsigned || needs_top_bit ? LiteralKind::kUint64 : LiteralKind::kInt64;
  } else {
    // Whether 3000000000 and 5000000000 are ints is a question of the shader model.
    number.kind = is_unsigned ? LiteralKind::kUint : LiteralKind::kInt;
  }
  return true;
}

Number ReadInteger(std::string_view text, std::size_t digits_begin, std::size_t digits_end,
                   int base) {
  Number number;
  number.length = digits_end;
  const auto result =
      std::from_chars(text.data() + digits_begin, text.data() + digits_end, number.value, base);
  if (result.ec == std::errc::result_out_of_range) {
    number.problem = NumberProblem::kTooLarge;
  } else if (digits_begin == digits_end) {
    number.problem = NumberProblem::kNotANumber;
  } else if (result.ptr != text.data() + digits_end) {
    number.problem = NumberProblem::kBadOctal;
  }
  if (!ReadIntegerSuffix(text, number)) number.problem = NumberProblem::kNotANumber;
  return number;
}

bool ReadFloatSuffix(std::string_view text, Number& number) {
  number.kind = LiteralKind::kFloat;
  switch (ToLower(At(text, number.length))) {
    case 'f': number.kind = LiteralKind::kTypedFloat; break;
    case 'h': number.kind = LiteralKind::kHalf; break;
    case 'l': number.kind = LiteralKind::kDouble; break;
    default: return !IsWordChar(At(text, number.length));
  }
  ++number.length;
  return !IsWordChar(At(text, number.length));
}

#ifdef __cpp_lib_to_chars
template <typename T>
std::from_chars_result ReadDigits(std::string_view digits, T& value, std::chars_format format) {
  return std::from_chars(digits.data(), digits.data() + digits.size(), value, format);
}
#else  // libc++ 19 reads no floating-point numbers
template <typename T>
std::from_chars_result ReadDigits(std::string_view digits, T& value, std::chars_format format) {
  const bool is_hex = format == std::chars_format::hex;
  const std::string text = (is_hex ? "0x" : "") + std::string(digits);
  const T read = sizeof(T) == sizeof(float) ? std::strtof(text.c_str(), nullptr)
                                            : static_cast<T>(std::strtod(text.c_str(), nullptr));
  const std::string_view mantissa = digits.substr(0, digits.find_first_of(is_hex ? "pP" : "eE"));
  const bool is_zero = mantissa.find_first_not_of("0.") == std::string_view::npos;
  if (std::isinf(read) || (read == 0 && !is_zero))
    return {digits.data() + digits.size(), std::errc::result_out_of_range};
  value = read;
  return {digits.data() + digits.size(), std::errc()};
}
#endif

// Reads a floating-point number whose digits are from `begin` to `end`. With the suffix `f` it is
// rounded to float at once: by way of double it could be rounded twice.
Number ReadFloat(std::string_view text, std::size_t begin, std::size_t end,
                 std::chars_format format) {
  Number number;
  number.length = end;
  const bool has_suffix = ToLower(At(text, end)) == 'f';
  if (!ReadFloatSuffix(text, number)) number.problem = NumberProblem::kNotANumber;
  double value = 0;
  const std::string_view digits = text.substr(begin, end - begin);
  auto result = ReadDigits(digits, value, format);
  if (result.ec == std::errc::result_out_of_range) {
    // strtod tells too large from too small.
    value = std::strtod(std::string(text.substr(0, end)).c_str(), nullptr);
  } else if (has_suffix) {
    float rounded = 0;
    result = ReadDigits(digits, rounded, format);
    value = result.ec == std::errc() ? rounded : static_cast<float>(value);
  }
  // Up to half a step above the largest float, 0x1.fffffep127, a number is rounded to that.
  const double infinite = number.kind == LiteralKind::kDouble
                              ? std::numeric_limits<double>::infinity()
                              : 0x1.ffffffp127;
  if (value >= infinite) {
    // Whether 1e300 is a double is a question of the shader model.
    if (number.kind != LiteralKind::kFloat) value = std::numeric_limits<double>::infinity();
    if (number.problem == NumberProblem::kNone) number.problem = NumberProblem::kInfinite;
  }
  number.value = std::bit_cast<std::uint64_t>(value);
  return number;
}

std::size_t SkipDigits(std::string_view text, std::size_t i, bool (*is_digit)(char)) {
  while (is_digit(At(text, i))) ++i;
  return i;
}

// The end of the exponent that starts at `i` with `mark`, or `i` if there is none.
std::size_t SkipExponent(std::string_view text, std::size_t i, char mark) {
  if (ToLower(At(text, i)) != mark) return i;
  std::size_t digits = i + 1;
  if (At(text, digits) == '+' || At(text, digits) == '-') ++digits;
  const std::size_t end = SkipDigits(text, digits, IsDigit);
  return end > digits ? end : i;
}

Number ReadHexadecimal(std::string_view text) {
  std::size_t i = SkipDigits(text, 2, IsHexDigit);
  const std::size_t integer_end = i;
  if (At(text, i) == '.') i = SkipDigits(text, i + 1, IsHexDigit);
  const std::size_t end = SkipExponent(text, i, 'p');
  if (end > i) return ReadFloat(text, 2, end, std::chars_format::hex);
  Number number = ReadInteger(text, 2, integer_end, 16);
  const bool has_suffix = number.length > integer_end;
  if (number.kind == LiteralKind::kInt && !has_suffix) number.kind = LiteralKind::kHexadecimal;
  return number;
}

Number ReadBinary(std::string_view text) {
  Number number = ReadInteger(text, 2, SkipDigits(text, 2, IsBinaryDigit), 2);
  number.is_binary = true;
  return number;
}

}  // namespace

Number ReadNumber(std::string_view text) {
  if (text.size() == 1)
    return {LiteralKind::kInt, static_cast<std::uint64_t>(text[0] - '0'), 1, NumberProblem::kNone};
  if (text[0] == '0' && ToLower(text[1]) == 'x') return ReadHexadecimal(text);
  if (text[0] == '0' && ToLower(text[1]) == 'b' && IsBinaryDigit(At(text, 2)))
    return ReadBinary(text);
  const std::size_t integer_end = SkipDigits(text, 0, IsDigit);
  std::size_t end = integer_end;
  if (At(text, end) == '.') end = SkipDigits(text, end + 1, IsDigit);
  end = SkipExponent(text, end, 'e');
  // `1.yyy` is the integer 1 and a swizzle, as DXC has it.
  constexpr std::string_view kSwizzleStarts = "xyzwrgba_";
  if (end == integer_end + 1 && end > 1 &&
      kSwizzleStarts.find(At(text, end)) != std::string_view::npos)
    end = integer_end;
  const char suffix = ToLower(At(text, end));
  if (end > integer_end || suffix == 'f' || suffix == 'h')
    return ReadFloat(text, 0, end, std::chars_format::general);
  return ReadInteger(text, 0, end, text[0] == '0' ? 8 : 10);
}

bool ReadSpecialNumber(std::string_view identifier, Number& number) {
  double value = std::numeric_limits<double>::quiet_NaN();
  if (identifier.starts_with("INF")) {
    value = std::numeric_limits<double>::infinity();
  } else if (!identifier.starts_with("IND") && !identifier.starts_with("QNAN") &&
             !identifier.starts_with("SNAN")) {
    return false;
  }
  number.kind = LiteralKind::kFloat;
  number.value = std::bit_cast<std::uint64_t>(value);
  return true;
}

void AppendUnescaped(std::string_view literal, std::string& out) {
  const std::size_t open = literal.find_first_of("\"'");
  if (open == std::string_view::npos || literal.size() < open + 2) return;
  std::string_view text = literal.substr(open + 1, literal.size() - open - 2);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      out += text[i];
      continue;
    }
    const char c = text[++i];
    constexpr std::string_view kLetters = "abfnrtv", kMeanings = "\a\b\f\n\r\t\v";
    const std::size_t simple = kLetters.find(c);
    const bool is_octal = c >= '0' && c <= '7';
    if (simple != std::string_view::npos) {
      out += kMeanings[simple];
    } else if (is_octal || (c == 'x' && IsHexDigit(At(text, i + 1)))) {
      const std::size_t begin = is_octal ? i : i + 1;
      const std::size_t size = std::min<std::size_t>(text.size() - begin, is_octal ? 3 : 2);
      unsigned value = 0;
      const auto end =
          std::from_chars(text.data() + begin, text.data() + begin + size, value, is_octal ? 8 : 16)
              .ptr;
      out += static_cast<char>(value);
      i = static_cast<std::size_t>(end - text.data()) - 1;
    } else {
      out += c;
    }
  }
}

std::uint32_t CharacterValue(std::string_view literal) {
  std::string characters;
  AppendUnescaped(literal, characters);
  std::uint32_t value = 0;
  for (char c : characters) value = value << 8 | static_cast<unsigned char>(c);
  return value;
}

}  // namespace clipc
