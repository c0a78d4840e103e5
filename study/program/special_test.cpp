// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The images of odd planes and odd triangles on a real clipper, for each way that can be given
// them.
#include "study/program/special.h"

#include <cmath>
#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "tools/harness/offscreen.h"

namespace clipc::study {
namespace {

class Special : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const harness::OpenGl opengl(harness::Api::kCompatibility);
    results_ = MeasureSpecial();
  }
  // Calls check(result) for each result with that name, and counts the ways.
  void For(const std::string& what, const std::function<void(const SpecialResult&)>& check) {
    std::set<std::string> ways;
    for (const SpecialResult& result : results_) {
      if (result.what != what) continue;
      SCOPED_TRACE(result.way);
      check(result);
      ways.insert(result.way);
    }
    EXPECT_GE(ways.size(), 8u) << what;
  }
  static bool Discards(const SpecialResult& result) { return result.way.starts_with("discard"); }

  static inline std::vector<SpecialResult> results_;
};

TEST_F(Special, AZeroPlaneClipsNothing) {
  For("0 0 0 0", [](const SpecialResult& result) { EXPECT_EQ(result.got, 1); });
  For("-0 0 0 -0", [](const SpecialResult& result) { EXPECT_EQ(result.got, 1); });
  For("0 0 0 -1",
      [](const SpecialResult& result) { EXPECT_EQ(result.got, 0); });  // the test can fail
}

TEST_F(Special, NotANumberClipsEverything) {
  For("NaN 0 0 1", [](const SpecialResult& result) { EXPECT_EQ(result.got, 0); });
}

// The reason why the runtime refuses planes of such lengths: the lengths that it lets pass harm
// nothing but a sheared depth.
TEST_F(Special, PlanesTooLongOrTooShortFail) {
  const auto is_right = [](const SpecialResult& result) {
    return std::fabs(result.got - result.right) < 0.002;
  };
  For("times 1e-35", [&](const SpecialResult& result) { EXPECT_TRUE(is_right(result)); });
  For("times 1e30", [&](const SpecialResult& result) {
    EXPECT_EQ(is_right(result), result.way != "near-plane");
  });
  For("times 1e-42",
      [&](const SpecialResult& result) { EXPECT_EQ(result.got, 1); });  // flushed to zero
  int wrong = 0;
  For("times 1e38", [&](const SpecialResult& result) { wrong += !is_right(result); });
  EXPECT_GE(wrong, 3);
}

// The parts that a plane and its opposite keep are the whole.
TEST_F(Special, TrianglesThroughTheEyesPlane) {
  int ways = 0;
  for (const SpecialResult& result : results_) {
    if (result.sweep != "triangles through w = 0") continue;
    EXPECT_EQ(result.got, result.right) << result.way << ", " << result.what;
    EXPECT_GT(result.got, 0.05) << result.way;
    if (result.what == "one half") {
      EXPECT_LT(result.got, 0.95) << result.way;
    }
    ++ways;
  }
  EXPECT_EQ(ways, 16);  // the sheared near plane refuses one of the halves
}

// Only a clipper antialiases the cut.
TEST_F(Special, MultisamplingSmoothsTheCutUnlessItIsDiscarded) {
  int ways = 0;
  for (const SpecialResult& result : results_) {
    if (result.sweep != "multisampling") continue;
    if (Discards(result)) {
      EXPECT_EQ(result.got, 0) << result.way;
    } else {
      EXPECT_GT(result.got, 0.9) << result.way;
    }
    ++ways;
  }
  EXPECT_GE(ways, 8);
}

}  // namespace
}  // namespace clipc::study
