// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The rounding that keeps `xyw1` above 0.002 pixels at narrow fields of view: that of the position
// in float32, which is the shader's and the rasteriser's, and not those of the constant or the dot
// product, which are clipc's.
#include "study/roundings.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace clipc::study {
namespace {

enum Rounding { kAll, kWithoutDot, kNorConstant, kPositionOnce, kNone };

std::vector<RoundingCost> At(double fov) { return MeasureRoundings(fov, 60, 500, 77); }

double TangentOfHalf(double fov) { return std::tan(fov * std::numbers::pi / 360); }

TEST(Roundings, AddUpToXyw1) {
  const std::vector<RoundingCost> costs = At(10);
  ASSERT_EQ(costs.size(), 5u);
  EXPECT_GT(costs[kAll].draws, 40);
  EXPECT_GT(costs[kAll].mean, costs[kWithoutDot].mean);
  EXPECT_GT(costs[kWithoutDot].mean, costs[kNorConstant].mean);
  EXPECT_GT(costs[kNorConstant].mean, costs[kPositionOnce].mean);
  EXPECT_LT(costs[kNone].worst, 1e-6);  // mutation: no rounding, no loss
}

// The best constant and the best dot product there can be would not do at 10 degrees; they would at
// 20, as would `xyw1` at 60.
TEST(Roundings, ThePositionAloneLosesMoreThanTheClaimAtTenDegrees) {
  EXPECT_GT(At(10)[kNorConstant].over, 2);
  EXPECT_EQ(At(20)[kNorConstant].over, 0);
  EXPECT_EQ(At(35)[kAll].over, 0);
}

// A position that is right to the last bit loses half a unit of its w, and a pixel is so much
// smaller as the view is narrower.
TEST(Roundings, GrowAsTheViewNarrows) {
  const double wide = 40;
  for (const double fov : {20.0, 10.0, 5.0, 1.0}) {
    const double law = TangentOfHalf(wide) / TangentOfHalf(fov);
    EXPECT_NEAR(At(fov)[kPositionOnce].mean / At(wide)[kPositionOnce].mean / law, 1, 0.25) << fov;
    EXPECT_NEAR(At(fov)[kAll].mean / At(wide)[kAll].mean / law, 1, 0.35) << fov;
  }
}

}  // namespace
}  // namespace clipc::study
