// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/shader_variant.h"

#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clipc::runtime {
namespace {

TEST(VariantOfTest, PlanesMoveToTheFront) {
  constexpr ShaderVariant kVariant = VariantOf(0b101001);
  static_assert(kVariant.plane_count == 3);
  EXPECT_EQ(kVariant.planes[0], 0);
  EXPECT_EQ(kVariant.planes[1], 3);
  EXPECT_EQ(kVariant.planes[2], 5);
  const Float4 from[6] = {{0, 0, 0, 0}, {1, 0, 0, 0}, {2, 0, 0, 0},
                          {3, 0, 0, 0}, {4, 0, 0, 0}, {5, 0, 0, 0}};
  Float4 to[3];
  CompactPlanes(kVariant, from, to);
  EXPECT_EQ(to[0].x, 0);
  EXPECT_EQ(to[1].x, 3);
  EXPECT_EQ(to[2].x, 5);
}

TEST(VariantOfTest, EveryMask) {
  for (unsigned mask = 0; mask < 64; ++mask) {
    const ShaderVariant variant = VariantOf(static_cast<BoxPlan>(mask));
    unsigned back = 0;
    for (unsigned slot = 0; slot < variant.plane_count; ++slot) {
      back |= 1u << variant.planes[slot];
      if (slot > 0) {
        EXPECT_LT(variant.planes[slot - 1], variant.planes[slot]);
      }
    }
    EXPECT_EQ(back, mask);
  }
}

TEST(OrderByPlaneCountTest, SortsAndLeavesOutTheCulled) {
  std::mt19937 random(1);
  for (std::size_t count = 0; count < 200; ++count) {
    std::vector<BoxPlan> plans(count);
    std::size_t drawn = 0;
    for (BoxPlan& plan : plans) {
      plan = random() % 4 == 0 ? kCulled : static_cast<BoxPlan>(random() % 64);
      drawn += plan != kCulled;
    }
    std::vector<std::uint32_t> order(count);
    std::size_t first[8];
    OrderByPlaneCount(plans.data(), count, order.data(), first);
    EXPECT_EQ(first[0], 0u);
    EXPECT_EQ(first[7], drawn);
    for (std::size_t k = 0; k < 7; ++k) {
      for (std::size_t i = first[k]; i < first[k + 1]; ++i) {
        EXPECT_NE(plans[order[i]], kCulled);
        EXPECT_EQ(VariantOf(plans[order[i]]).plane_count, k);
        if (i > first[k]) {
          EXPECT_LT(order[i - 1], order[i]) << "equal ones stay in order";
        }
      }
    }
  }
}

}  // namespace
}  // namespace clipc::runtime
