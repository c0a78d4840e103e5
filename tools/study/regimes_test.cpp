// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// PredictEdgeError held against measurements in the regimes that users are in, over planes, cameras
// and objects that nobody chose. `clipc-study` does the same with 10,000 draws (laws.csv).
#include "tools/study/regimes.h"

#include <gtest/gtest.h>

#include "runtime/plane_space.h"

namespace clipc::study {
namespace {

using Law = std::function<std::optional<double>(const RegimeDraw&)>;

// With room for a mutation to break more than a draw's luck.
bool NearlyHolds(const RegimeHeld& held) {
  return held.pooled > 0.2 && held.pooled < 3 && held.high <= 0.06 * held.draws &&
         held.low <= 0.15 * held.draws;
}

TEST(Regimes, MeasuredErrorsAreWithinAFactorOfTheirLaw) {
  for (const RegimeHeld& held : HoldLaw(1100, 40, 31, LawOf)) {
    EXPECT_GT(held.draws, 60) << NameOf(held.regime);
    EXPECT_EQ(held.low + held.high, 0)
        << NameOf(held.regime) << ": " << held.least << " to " << held.most;
    EXPECT_NEAR(held.median, 1, 0.3) << NameOf(held.regime);
    EXPECT_NEAR(held.pooled, 1, 0.4) << NameOf(held.regime);
  }
}

// A law that leaves out what `change` takes from the draw.
Law Without(const std::function<void(RegimeDraw&)>& change) {
  return [change](const RegimeDraw& draw) {
    RegimeDraw changed = draw;
    change(changed);
    return LawOf(changed);
  };
}

// Mutations: without its term, a law does not hold in its regime.
TEST(Regimes, EachTermIsNeeded) {
  const auto breaks = [](Regime regime, const std::function<void(RegimeDraw&)>& change) {
    const auto held = HoldLaw(440, 30, 33, Without(change));
    return !NearlyHolds(held[static_cast<std::size_t>(regime)]);
  };
  EXPECT_TRUE(breaks(Regime::kMeshOffset, [](RegimeDraw& d) { d.config.mesh_offset = 0; }));
  for (const Regime regime :
       {Regime::kMatricesInTheShader, Regime::kFloatProduct, Regime::kWorldSpace})
    EXPECT_TRUE(breaks(regime, [](RegimeDraw& d) {
      d.regime = Regime::kOrdinary;
      d.space = d.space.value_or(PlaneSpace::kObject);
    })) << NameOf(regime);
  // As if the eye stood in the plane, and depth began there.
  EXPECT_TRUE(breaks(Regime::kOrthographic, [](RegimeDraw& d) {
    d.config.view_plane.w = 0, d.config.camera.near = 1e-9 * d.config.camera.far;
    d.config.camera.reversed = false;
  }));
  EXPECT_TRUE(breaks(Regime::kMinusOneToOne,
                     [](RegimeDraw& d) { d.config.camera.negative_one_to_one = false; }));
  EXPECT_TRUE(breaks(Regime::kOffCentre, [](RegimeDraw& d) {
    d.config.camera.offset_x = d.config.camera.offset_y = 0;
  }));
}

}  // namespace
}  // namespace clipc::study
