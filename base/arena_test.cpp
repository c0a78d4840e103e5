// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/arena.h"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

namespace clipc {
namespace {

// Nodes of several sizes have blocks of other lengths: one value in a block, and thousands.
template <std::size_t kWords>
struct Node {
  std::array<std::uint32_t, kWords> words{};
};

template <typename T>
class ArenaTest : public testing::Test {};
using Sizes = testing::Types<Node<1>, Node<9>, Node<13>, Node<300>>;
TYPED_TEST_SUITE(ArenaTest, Sizes);

// More values than the small blocks of any size hold, and than one large block after them.
constexpr std::uint32_t kCount = 20'000;

TYPED_TEST(ArenaTest, KeepsValuesAndReferences) {
  Arena<TypeParam> arena;
  const TypeParam* first = nullptr;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto id = arena.Add({{i}});
    ASSERT_EQ(id.index, i);
    if (i == 0) first = &arena[id];
  }
  ASSERT_EQ(arena.size(), kCount);
  EXPECT_EQ(&arena[Id<TypeParam>{0}], first);
  for (const auto id : arena.ids()) ASSERT_EQ(arena[id].words[0], id.index);
}

TYPED_TEST(ArenaTest, ACopyGrowsByItself) {
  for (const std::uint32_t count : {0u, 1u, 63u, 64u, 65u, 4096u, 4097u, kCount}) {
    Arena<TypeParam> arena;
    for (std::uint32_t i = 0; i < count; ++i) arena.Add({{i}});
    Arena<TypeParam> copy = arena;
    for (std::uint32_t i = 0; i < 100; ++i) copy.Add({{count + i}});
    EXPECT_EQ(arena.size(), count);
    for (const auto id : copy.ids()) ASSERT_EQ(copy[id].words[0], id.index) << count;
  }
}

}  // namespace
}  // namespace clipc
