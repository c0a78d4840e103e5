// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// "D3DCLIPSTATUS9 Structure" (Microsoft), section by section.
#include <vector>

#include <gtest/gtest.h>

#include "runtime/clip_status.h"

namespace clipc::runtime {
namespace {

ClipStatus StatusOf(const std::vector<float>& positions, const UserClipPlanes& user = {}) {
  ClipStatus status;
  UpdateClipStatus(status, positions.data(), positions.size() / 4, user, true);
  return status;
}

TEST(Seed002Members, EachPlaneHasItsFlag) {
  EXPECT_EQ(StatusOf({-2, 0, 0, 1}).clip_union, kClipLeft);
  EXPECT_EQ(StatusOf({2, 0, 0, 1}).clip_union, kClipRight);
  EXPECT_EQ(StatusOf({0, 2, 0, 1}).clip_union, kClipTop);
  EXPECT_EQ(StatusOf({0, -2, 0, 1}).clip_union, kClipBottom);
  EXPECT_EQ(StatusOf({0, 0, -1, 1}).clip_union, kClipFront);
  EXPECT_EQ(StatusOf({0, 0, 2, 1}).clip_union, kClipBack);
  for (std::uint32_t i = 0; i < 6; ++i) {
    UserClipPlanes user;
    user.planes[i][3] = -1;
    user.enable_mask = 1u << i;
    EXPECT_EQ(StatusOf({0, 0, 0, 1}, user).clip_union, std::uint32_t{kClipPlane0} << i);
  }
}

TEST(Seed002Members, AllIsTheCombinationOfAllFlags) {
  EXPECT_EQ(kClipLeft | kClipRight | kClipTop | kClipBottom | kClipFront | kClipBack |
                0x3Fu * kClipPlane0,
            std::uint32_t{kClipAll});
}

// The document says "all vertices are clipped by" of the flags of both members. That is so of
// ClipIntersection; a flag of ClipUnion says that at least one vertex is.
TEST(Seed002Members, AFlagOfTheUnionMeansAtLeastOneVertex) {
  const UserClipPlanes user = {{{1, 0, 0, 0}, {-1, 0, 0, 1}}, 3};  // 0 <= x <= 1
  const ClipStatus status = StatusOf({-1, 0, 0, 9, 0.5f, 0, 0, 9, 2, 0, 0, 1, 3, 0, 0, 1}, user);
  EXPECT_EQ(status.clip_union & (3u * kClipPlane0), 3u * kClipPlane0);
  EXPECT_EQ(status.clip_intersection, 0u);
  const ClipStatus all = StatusOf({2, 0, 0, 1, 3, 0, 0, 1}, user);
  EXPECT_EQ(all.clip_intersection, std::uint32_t{kClipRight} | kClipPlane0 << 1);
}

TEST(Seed002Remarks, UnionIsTheOrOfAllCodesAndIntersectionTheAnd) {
  const ClipStatus status = StatusOf({-2, 2, 0, 1, -2, 0, 3, 1});
  EXPECT_EQ(status.clip_union, std::uint32_t{kClipLeft} | kClipTop | kClipBack);
  EXPECT_EQ(status.clip_intersection, kClipLeft);
}

TEST(Seed002ClipStatus, UnionStartsAtZero) { EXPECT_EQ(ClipStatus{}.clip_union, 0u); }

TEST(Seed002ClipStatus, IntersectionStartsAtAllOnes) {
  EXPECT_EQ(ClipStatus{}.clip_intersection, 0xFFFFFFFFu);
}

TEST(Seed002Remarks, ClippingOffSetsBothToZero) {
  ClipStatus status = StatusOf({-2, 0, 0, 1});
  const float position[4] = {9, 9, 9, 1};
  UpdateClipStatus(status, position, 1, {}, false);
  EXPECT_EQ(status.clip_union, 0u);
  EXPECT_EQ(status.clip_intersection, 0u);
}

// An empty draw leaves the initial values, whose intersection has bits that no clip code has.
TEST(Seed002Remarks, AnEmptyDrawSaysNothing) {
  EXPECT_EQ(StatusOf({}).clip_union, 0u);
  EXPECT_NE(StatusOf({}).clip_intersection & ~std::uint32_t{kClipAll}, 0u);
}

TEST(Seed002Remarks, DrawsAddUpUntilTheStatusIsReset) {
  ClipStatus status;
  const float left[4] = {-2, 0, 0, 1}, right[4] = {2, 0, 0, 1};
  UpdateClipStatus(status, left, 1, {}, true);
  UpdateClipStatus(status, right, 1, {}, true);
  EXPECT_EQ(status.clip_union, std::uint32_t{kClipLeft} | kClipRight);
  EXPECT_EQ(status.clip_intersection, 0u);
  status = {};
  UpdateClipStatus(status, right, 1, {}, true);
  EXPECT_EQ(status.clip_union, kClipRight);
  EXPECT_EQ(status.clip_intersection, kClipRight);
}

// An intersection of 0 does not prove that something is visible.
TEST(Seed002Remarks, AnInvisibleTriangleMayHaveNoIntersection) {
  const ClipStatus status = StatusOf({-2, 0, 0, 1, 0, 9, 0, 1, -9, 9, 0, 1});
  EXPECT_EQ(status.clip_union, std::uint32_t{kClipLeft} | kClipTop);
  EXPECT_EQ(status.clip_intersection, 0u);
}

}  // namespace
}  // namespace clipc::runtime
