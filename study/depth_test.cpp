// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The order that a sheared near plane leaves in the depth buffer, as laws with a mutation each.
#include "study/depth.h"

#include <map>

#include <gtest/gtest.h>

namespace clipc::study {
namespace {

// The results by method, for a level plane that the eye is `eye` above.
std::map<std::string, DepthLeft> At(double eye, const Camera& camera = {}) {
  std::map<std::string, DepthLeft> by_method;
  for (const DepthLeft& left : MeasureDepth(camera, {0, 1, 0, eye}, 4000, 5))
    by_method[left.method] = left;
  return by_method;
}

// The plane's distance takes the near distance's place: with the eye behind the plane by the near
// distance or more, depth is as good as without; at half of that distance nothing but half as near
// would be.
TEST(Depth, IsAsGoodAsThePlaneIsFar) {
  for (const double eye : {-100.0, -10.0, -1.0}) {
    auto left = At(eye);
    EXPECT_FALSE(left["near-plane"].refused) << eye;
    EXPECT_GE(left["near-plane"].effective_near, Camera{}.near * 0.99) << eye;
    EXPECT_GE(left["near-plane"].ordered, left["standard"].ordered - 0.01) << eye;
    EXPECT_EQ(left["near-plane"].inverted, 0) << eye;
  }
  EXPECT_LT(At(-0.001)["near-plane"].ordered,
            At(-1)["near-plane"].ordered - 0.1);  // mutation: nearer
  Camera shallow;
  shallow.near = 0.001;
  EXPECT_LT(At(-1, shallow)["standard"].ordered,
            At(-1)["standard"].ordered);  // the measure knows what a near distance does
}

// With the eye on the kept side the order of depths is turned around, and the runtime refuses.
TEST(Depth, IsInvertedOnTheKeptSide) {
  for (const double eye : {1.0, 10.0}) {
    auto left = At(eye);
    EXPECT_TRUE(left["near-plane"].refused) << eye;
    EXPECT_GT(left["near-plane"].inverted, 0.99) << eye;
    EXPECT_EQ(left["standard"].inverted, 0) << eye;  // mutation: no shear
    EXPECT_EQ(left["reversed"].inverted, 0) << eye;
  }
  EXPECT_TRUE(At(0)["near-plane"].refused);
}

// Lengyel's scale keeps all that is visible; the plane as it is takes a share of it away at the far
// plane.
TEST(Depth, LengyelsScaleLosesNothingAtTheFarPlane) {
  for (const double eye : {-10.0, -1.0}) {
    EXPECT_LT(At(eye)["near-plane"].lost, 0.001) << eye;
    EXPECT_LT(At(eye)["standard"].lost, 0.001) << eye;
  }
  const runtime::Plane slanted = {0, 3, 4, -5};  // five times a unit plane
  for (const DepthLeft& left : MeasureDepth(Camera{}, slanted, 4000, 5)) {
    if (left.method == "near-plane") {
      EXPECT_LT(left.lost, 0.001);
    } else if (left.method == "near-plane-unit") {
      EXPECT_GT(left.lost, 0.2);  // mutation: another scale
    }
  }
}

}  // namespace
}  // namespace clipc::study
