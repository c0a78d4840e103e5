// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/kept_blocks.h"

#include <cstring>
#include <numeric>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace clipc {
namespace {

TEST(KeptBlocks, AreAsLargeAsAskedFor) {
  KeepBlocks();
  for (int round = 0; round < 2; ++round) {
    KeptVector<void*> blocks;
    for (std::size_t size = 0; size < 5000; ++size) {
      blocks.push_back(TakeBlock(size));
      std::memset(blocks.back(), static_cast<int>(size % 251), size);
    }
    for (std::size_t size = 0; size < 5000; ++size) {
      const auto* const bytes = static_cast<const unsigned char*>(blocks[size]);
      for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(bytes[i], size % 251);
      DropBlock(blocks[size], size);
    }
  }
}

TEST(KeptBlocks, AreDroppedByAnyThread) {
  KeptVector<int> numbers(100);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::thread([moved = std::move(numbers)]() mutable {
    KeepBlocks();
    EXPECT_EQ(moved.back(), 99);
    moved = {};
    moved.resize(100);
    EXPECT_EQ(moved.back(), 0);
  }).join();
}

TEST(KeptBlocks, HoldAMap) {
  KeptMap<std::string, int> map;
  for (int i = 0; i < 1000; ++i) map[std::to_string(i)] = i;
  for (int i = 0; i < 1000; i += 2) map.erase(std::to_string(i));
  EXPECT_EQ(map.size(), 500u);
  EXPECT_EQ(map.at("999"), 999);
}

}  // namespace
}  // namespace clipc
