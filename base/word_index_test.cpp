// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/word_index.h"

#include <gtest/gtest.h>

namespace clipc {
namespace {

// The last two hash alike: they differ in letters that the hash does not read.
constexpr std::array<std::string_view, 12> kWords = {"",       "a",      "b",         "float",
                                                     "float2", "float3", "abcb",      "accb",
                                                     "vec23",  "vec32",  "aXbXcXdXe", "aYbXcXdYe"};
constexpr WordIndex kIndex(kWords);

TEST(WordIndex, FindsEachWordWhereItStands) {
  for (std::size_t i = 0; i < kWords.size(); ++i) EXPECT_EQ(kIndex.Find(kWords[i]), i) << kWords[i];
}

TEST(WordIndex, FindsNothingElse) {
  for (const std::string_view word : {"c", "Float", "float4", "floa", "abdb", "aZbXcZdXe"}) {
    EXPECT_FALSE(kIndex.Has(word)) << word;
  }
}

}  // namespace
}  // namespace clipc
