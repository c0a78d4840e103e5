// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/scenes/comparison.h"

#include <gtest/gtest.h>

namespace clipc::scenes {
namespace {

using Pixels = std::vector<std::uint8_t>;

TEST(Compare, TellsTheCutFromTheRest) {
  const Pixels one = {1, 2, 3, 255, 1, 2, 3, 255, 1, 2, 3, 255},
               other = {9, 2, 3, 255, 1, 2, 9, 255, 1, 2, 3, 0};
  const Pixels cuts = {255, 255, 255, 255, 0, 0, 0, 255, 255, 255, 255, 255};
  const Comparison comparison = Compare(one, other, cuts);
  EXPECT_EQ(comparison.cut_pixels, 2);
  EXPECT_EQ(comparison.differ_at_cut, 1);
  EXPECT_EQ(comparison.differ_elsewhere, 1);
}

TEST(Compare, AnImageOfAnotherSizeDiffersEverywhere) {
  EXPECT_EQ(Compare({}, {1, 2, 3, 255}, {0, 0, 0, 255}).differ_elsewhere, 1);
}

TEST(Agree, OnePixelAwayFromTheCutsIsTooMuch) {
  EXPECT_TRUE(Agree({1000, 0, 0}, 0.01));
  EXPECT_FALSE(Agree({1000, 0, 1}, 0.01));
}

TEST(Agree, AtTheCutsTheErrorDecides) {
  // 500 pixels of cut, up to 2 * (0.01 + 0.0039) apart: 13.9 pixels, doubled and with 4 for chance.
  EXPECT_TRUE(Agree({1000, 31, 0}, 0.01));
  EXPECT_FALSE(Agree({1000, 32, 0}, 0.01));
  EXPECT_FALSE(Agree({1000, 31, 0}, 0.001));
}

}  // namespace
}  // namespace clipc::scenes
