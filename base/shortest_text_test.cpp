// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/shortest_text.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace clipc {
namespace {

std::string TextOfTheLibrary(double value) {
  char text[64];
  return {text, std::to_chars(text, std::end(text), value).ptr};
}

TEST(ShortestText, IsTheLibrarysForNumbersOfEveryKind) {
  using Limits = std::numeric_limits<double>;
  for (const double value : {0.0,
                             -0.0,
                             1.0,
                             -1.0,
                             0.5,
                             0.1,
                             0.001,
                             0.0001,
                             1e-5,
                             10.0,
                             100.0,
                             1e4,
                             1e5,
                             123456.0,
                             1e15,
                             1e16,
                             1e17,
                             1.5e22,
                             123456789012345678.0,
                             9007199254740993.0,
                             0x1p53,
                             0x1p64,
                             0x1p70,
                             Limits::min(),
                             Limits::max(),
                             Limits::denorm_min(),
                             Limits::infinity(),
                             -Limits::infinity(),
                             Limits::quiet_NaN()})
    EXPECT_EQ(ShortestText(value), TextOfTheLibrary(value));
}

TEST(ShortestText, IsTheLibrarysForRandomNumbers) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const double any = std::bit_cast<double>(random());
    const double of_shaders = std::ldexp(static_cast<double>(random() >> (random() % 64)),
                                         static_cast<int>(random() % 80) - 60);
    for (const double value : {any, of_shaders, std::round(of_shaders)})
      ASSERT_EQ(ShortestText(value), TextOfTheLibrary(value));
  }
}

TEST(ShortestText, AFloatHasFewerDigits) {
  EXPECT_EQ(ShortestText(0.1f), "0.1");
  EXPECT_EQ(ShortestText(16777216.0f), "16777216");
  EXPECT_EQ(ShortestText(-1e30f), "-1e+30");
}

}  // namespace
}  // namespace clipc
