// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/lex/literal.h"

#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace clipc {
namespace {

double Float(std::string_view text) { return std::bit_cast<double>(ReadNumber(text).value); }

TEST(ReadNumber, Integers) {
  struct Case {
    const char* text;
    LiteralKind kind;
    std::uint64_t value;
  };
  constexpr Case kCases[] = {
      {"0", LiteralKind::kInt, 0},
      {"7", LiteralKind::kInt, 7},
      {"42", LiteralKind::kInt, 42},
      {"017", LiteralKind::kInt, 15},
      {"0x1F", LiteralKind::kHexadecimal, 31},
      {"0x1Fl", LiteralKind::kInt, 31},
      {"0X1fu", LiteralKind::kUint, 31},
      {"5l", LiteralKind::kInt, 5},
      {"5UL", LiteralKind::kUint, 5},
      {"5ll", LiteralKind::kInt64, 5},
      {"5ULL", LiteralKind::kUint64, 5},
      {"5llu", LiteralKind::kUint64, 5},
      {"2147483647", LiteralKind::kInt, 2147483647},
      {"2147483648", LiteralKind::kInt, 2147483648},
      {"0xFFFFFFFF", LiteralKind::kHexadecimal, 0xFFFFFFFF},
      {"0b101", LiteralKind::kInt, 5},
      {"0B11u", LiteralKind::kUint, 3},
      {"0b1ll", LiteralKind::kInt64, 1},
      {"4294967296", LiteralKind::kInt, 4294967296},
      {"18446744073709551615", LiteralKind::kUint64, std::numeric_limits<std::uint64_t>::max()},
  };
  for (const Case& test : kCases) {
    const Number number = ReadNumber(test.text);
    EXPECT_EQ(number.problem, NumberProblem::kNone) << test.text;
    EXPECT_EQ(number.kind, test.kind) << test.text;
    EXPECT_EQ(number.value, test.value) << test.text;
    EXPECT_EQ(number.length, std::string_view(test.text).size()) << test.text;
  }
}

TEST(ReadNumber, Floats) {
  EXPECT_EQ(Float(".5"), 0.5);
  EXPECT_EQ(Float("1."), 1.0);
  EXPECT_EQ(Float("1.f"), 1.0);
  EXPECT_EQ(Float("1f"), 1.0);
  EXPECT_EQ(Float("1e3"), 1000.0);
  EXPECT_EQ(Float("1.5E-2"), 0.015);
  EXPECT_EQ(Float("0x1.8p1"), 3.0);
  EXPECT_EQ(Float("08.5"), 8.5);
  EXPECT_EQ(Float("1e-400"), 0.0);
  EXPECT_EQ(ReadNumber("1.0h").kind, LiteralKind::kHalf);
  EXPECT_EQ(ReadNumber("1.0L").kind, LiteralKind::kDouble);
  EXPECT_EQ(ReadNumber("1.0").kind, LiteralKind::kFloat);
  EXPECT_EQ(ReadNumber("1f").kind, LiteralKind::kTypedFloat);
}

TEST(ReadNumber, LargestFloat) {
  for (const char* text : {"3.4028235e38", "3.40282347e+38", "3.4028235e38f"}) {
    EXPECT_EQ(ReadNumber(text).problem, NumberProblem::kNone) << text;
    EXPECT_EQ(static_cast<float>(Float(text)), std::numeric_limits<float>::max()) << text;
  }
}

TEST(ReadNumber, SuffixRoundsToFloatOnce) {
  EXPECT_EQ(Float("0.1f"), 0.1f);
  EXPECT_EQ(Float("0.1"), 0.1);
  // Halfway between two floats but for the last digit: by way of double it would be rounded to
  // even, downwards.
  EXPECT_EQ(Float("1.00000005960464477539062500000000000000000000000000001f"),
            std::nextafter(1.0f, 2.0f));
}

TEST(ReadNumber, StopsWhereHlslDoes) {
  EXPECT_EQ(ReadNumber("1.0.yyy").length, 3u);
  EXPECT_EQ(ReadNumber("1.yyy").length, 1u);
  EXPECT_EQ(ReadNumber("1..xxx").length, 2u);
  EXPECT_EQ(ReadNumber("0x1e+2").length, 4u);
  EXPECT_EQ(ReadNumber("2.0f.x").length, 4u);
}

TEST(ReadNumber, Problems) {
  for (const char* text :
       {"1abc", "0x", "0xg", "0b", "0b2", "0b12", "1.0q", "1uu", "1lul", "1.0ff", "1e", "1.0e+"}) {
    EXPECT_EQ(ReadNumber(text).problem, NumberProblem::kNotANumber) << text;
  }
  EXPECT_EQ(ReadNumber("089").problem, NumberProblem::kBadOctal);
  EXPECT_EQ(ReadNumber("18446744073709551616").problem, NumberProblem::kTooLarge);
  // From the halfway point to the next float on.
  for (const char* text : {"3.4028235677973367e38", "3.4028235677973367e38f", "1e39", "1e39f",
                           "1e400", "3.5e38h", "1e400L"}) {
    EXPECT_EQ(ReadNumber(text).problem, NumberProblem::kInfinite) << text;
    EXPECT_TRUE(std::isinf(static_cast<float>(Float(text)))) << text;
  }
  // A double may have a number without a suffix.
  EXPECT_EQ(Float("1e39"), 1e39);
  EXPECT_TRUE(std::isinf(Float("1e39f")));
  EXPECT_EQ(ReadNumber("1e39L").problem, NumberProblem::kNone);
}

TEST(ReadSpecialNumber, MicrosoftsNames) {
  Number number;
  EXPECT_TRUE(ReadSpecialNumber("INF", number));
  EXPECT_TRUE(std::isinf(std::bit_cast<double>(number.value)));
  EXPECT_TRUE(ReadSpecialNumber("IND00", number));
  EXPECT_TRUE(std::isnan(std::bit_cast<double>(number.value)));
  EXPECT_FALSE(ReadSpecialNumber("inf", number));
}

TEST(Unescape, Strings) {
  const auto text = [](std::string_view literal) {
    std::string out;
    AppendUnescaped(literal, out);
    return out;
  };
  EXPECT_EQ(text(R"("a\n\t\"\\\x41\101\q")"), "a\n\t\"\\AAq");
  EXPECT_EQ(text("\"\""), "");
  EXPECT_EQ(text("\""), "");
  EXPECT_EQ(CharacterValue("'a'"), 97u);
  EXPECT_EQ(CharacterValue("'ab'"), 97u << 8 | 98u);
}

}  // namespace
}  // namespace clipc
