// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/spelling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clipc {
namespace {

TEST(EditDistance, CountsInsertedDeletedReplacedAndSwappedLetters) {
  EXPECT_EQ(EditDistance("main", "main", 3), 0);
  EXPECT_EQ(EditDistance("main", "MAIN", 3), 0) << "case does not count";
  EXPECT_EQ(EditDistance("man", "main", 3), 1);
  EXPECT_EQ(EditDistance("mainn", "main", 3), 1);
  EXPECT_EQ(EditDistance("moin", "main", 3), 1);
  EXPECT_EQ(EditDistance("mian", "main", 3), 1);
  EXPECT_EQ(EditDistance("unlti", "until", 3), 2) << "no letter is swapped twice";
  EXPECT_EQ(EditDistance("", "ab", 3), 2);
}

TEST(EditDistance, GivesUpBeyondItsLimit) {
  EXPECT_EQ(EditDistance("abcdef", "ghijkl", 2), 3);
  EXPECT_EQ(EditDistance("a", "abcd", 2), 3);
  EXPECT_EQ(EditDistance("bacde", "abced", 2), 2)
      << "a swap at the end reaches over a row that is too far";
}

TEST(NearNames, AreTheNearestThreeFirst) {
  constexpr std::string_view kNames[] = {"main", "mains", "mean", "vertex_main", "mine"};
  EXPECT_THAT(NearNames("mian", kNames), testing::ElementsAre("main", "mean"));
  EXPECT_THAT(NearNames("mein", kNames), testing::ElementsAre("main", "mean"));
  EXPECT_THAT(NearNames("VERTEX_MIAN", kNames), testing::ElementsAre("vertex_main"));
  EXPECT_THAT(NearNames("nothing", kNames), testing::IsEmpty());
  EXPECT_THAT(NearNames("a", std::vector<std::string_view>{"b", "ab"}), testing::IsEmpty());
}

}  // namespace
}  // namespace clipc
