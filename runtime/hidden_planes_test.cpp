// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/hidden_planes.h"

#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

// Half spaces a x + b y + c z + d >= 0 in whole numbers.
struct HalfSpace {
  std::int64_t n[3], d;
};

// Whether a place is in all of them, exactly: what is bounded and not empty has a corner, where
// three meet.
bool HaveAPlace(const HalfSpace* spaces, std::size_t count) {
  const auto minor = [](const std::int64_t* a, const std::int64_t* b, int i, int j) {
    return a[i] * b[j] - a[j] * b[i];
  };
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      for (std::size_t k = j + 1; k < count; ++k) {
        const HalfSpace &a = spaces[i], &b = spaces[j], &c = spaces[k];
        std::int64_t determinant = 0, place[3];
        for (int axis = 0; axis < 3; ++axis) {
          const int x = (axis + 1) % 3, y = (axis + 2) % 3;
          determinant += a.n[axis] * minor(b.n, c.n, x, y);
          place[axis] = -(a.d * minor(b.n, c.n, x, y) + b.d * minor(c.n, a.n, x, y) +
                          c.d * minor(a.n, b.n, x, y));
        }
        if (determinant == 0) continue;
        const std::int64_t sign = determinant < 0 ? -1 : 1;
        bool is_in = true;
        for (std::size_t l = 0; l < count && is_in; ++l) {
          std::int64_t value = spaces[l].d * determinant;
          for (int axis = 0; axis < 3; ++axis) value += spaces[l].n[axis] * place[axis];
          is_in = value * sign >= 0;
        }
        if (is_in) return true;
      }
    }
  }
  return false;
}

// Exactly: whether all planes of `by` keep something of the box; of what `plane` removes, if it is
// one.
bool IsSeen(const Box& box, const HalfSpace* planes, std::size_t plane, std::uint32_t by) {
  HalfSpace spaces[12] = {};
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    HalfSpace &above = spaces[count++], &below = spaces[count++];
    above.n[axis] = 1, above.d = -static_cast<std::int64_t>(box.low[axis]);
    below.n[axis] = -1, below.d = static_cast<std::int64_t>(box.high[axis]);
  }
  if (plane < 6) {
    const HalfSpace& p = planes[plane];
    spaces[count++] = {{-p.n[0], -p.n[1], -p.n[2]}, -p.d};
  }
  for (std::size_t j = 0; j < 6; ++j) {
    if (j != plane && (by >> j & 1) != 0) spaces[count++] = planes[j];
  }
  return HaveAPlace(spaces, count);
}

// No plane is left out that matters, and none stays that does not, where whole numbers say so.
TEST(HiddenPlanes, AreThoseThatWholeNumbersSay) {
  Random random(61);
  int dropped = 0, kept = 0, culled = 0;
  for (int i = 0; i < 60'000; ++i) {
    const auto whole = [&](int most) {
      return static_cast<int>(random.Below(2 * static_cast<std::uint32_t>(most) + 1)) - most;
    };
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      const int middle = whole(6), half = 1 + static_cast<int>(random.Below(5));
      box.low[axis] = static_cast<float>(middle - half);
      box.high[axis] = static_cast<float>(middle + half);
    }
    HalfSpace exact[6] = {};
    Float4 planes[6];
    const std::size_t count = 2 + random.Below(5);
    for (std::size_t j = 0; j < count; ++j) {
      // Axes are common.
      const int most = random.Below(3) == 0 ? 1 : 5;
      exact[j] = {{whole(most), whole(most), whole(most)}, whole(12)};
      planes[j] = {static_cast<float>(exact[j].n[0]), static_cast<float>(exact[j].n[1]),
                   static_cast<float>(exact[j].n[2]), static_cast<float>(exact[j].d)};
    }
    const BoxPlan plan = PlanBox(box, planes, count);
    const BoxPlan without = WithoutHiddenPlanes(box, planes, count, plan);
    if (plan == kCulled) {
      EXPECT_EQ(without, kCulled);
      continue;
    }
    const bool is_culled = !IsSeen(box, exact, 6, plan);
    EXPECT_EQ(without == kCulled, is_culled);
    culled += is_culled ? 1 : 0;
    for (std::size_t j = 0; j < count && !is_culled; ++j) {
      if ((plan >> j & 1) == 0) continue;
      const bool is_kept = (without >> j & 1) != 0;
      EXPECT_EQ(is_kept, IsSeen(box, exact, j, without)) << (is_kept ? "needless" : "a false drop");
      (is_kept ? kept : dropped) += 1;
    }
  }
  EXPECT_GT(dropped, 10'000);
  EXPECT_GT(kept, 40'000);
  EXPECT_GT(culled, 1'000);
}

TEST(HiddenPlanes, ByHand) {
  const Box box = {{-1, -1, -1}, {1, 1, 1}};
  const Float4 lower = {0, 1, 0, 0.5f}, upper = {0, 1, 0, 0}, across = {1, 0, 0, 0};
  const Float4 planes[] = {lower, upper, across};
  EXPECT_EQ(PlanBox(box, planes, 3), 0b111);
  EXPECT_EQ(WithoutHiddenPlanes(box, planes, 3, 0b111), 0b110) << "the upper hides the lower";
  const Float4 same[] = {upper, upper};
  EXPECT_EQ(WithoutHiddenPlanes(box, same, 2, 0b11), 0b11) << "a difference of rounding decides";
  // Two planes that meet before a corner hide a third behind their edge.
  const Float4 corner[] = {{1, 1, 0, 1.5f}, {1, 0, 0, 0.5f}, {0, 1, 0, 0.5f}};
  EXPECT_EQ(WithoutHiddenPlanes(box, corner, 3, 0b111), 0b110);
  const Float4 tip[] = {{1, 1, 1, 2.5f}, {1, 0, 0, 0.5f}, {0, 1, 0, 0.5f}, {0, 0, 1, 0.5f}};
  EXPECT_EQ(WithoutHiddenPlanes(box, tip, 4, 0b1111), 0b1110);
  const Float4 apart[] = {{1, 1, 0, -0.5f}, {-1, -1, 0, -0.5f}};
  EXPECT_EQ(PlanBox(box, apart, 2), 0b11);
  EXPECT_EQ(WithoutHiddenPlanes(box, apart, 2, 0b11), kCulled);
}

TEST(HiddenPlanes, WhatIsNotJudgedStays) {
  const Box box = {{-1, -1, -1}, {1, 1, 1}};
  const Float4 planes[] = {{0, 1, 0, 0.5f}, {0, 1, 0, 0}};
  EXPECT_EQ(WithoutHiddenPlanes(box, planes, 2, 0b01), 0b01);
  EXPECT_EQ(WithoutHiddenPlanes(box, planes, 2, kCulled), kCulled);
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), 3e38f, std::numeric_limits<float>::infinity()}) {
    for (const int i : {0, 1}) {
      Float4 broken[] = {planes[0], planes[1]};
      broken[i].w = bad;
      EXPECT_EQ(WithoutHiddenPlanes(box, broken, 2, 0b11), 0b11) << bad << ' ' << i;
    }
    Box open = box;
    open.high[0] = bad;
    EXPECT_EQ(WithoutHiddenPlanes(open, planes, 2, 0b11), 0b11) << bad;
  }
}

}  // namespace
}  // namespace clipc::runtime
