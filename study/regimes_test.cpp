// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// PredictEdgeError held against measurements in the regimes that users are in, over planes, cameras
// and objects that nobody chose. `clipc-study` does the same with 10,000 draws of each regime
// (laws.csv).
#include "study/regimes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "runtime/plane_space.h"
#include "tools/harness/camera.h"

namespace clipc::study {
namespace {

using runtime::MatrixOrder;
using Law = std::function<runtime::EdgeDisplacement(const RegimeDraw&)>;

// Whether the law nearly holds: the bounds leave room for the luck of single draws, so that a
// mutation must break more.
bool NearlyHolds(const RegimeHeld& regime) {
  const Held& held = regime.along_surface;
  return held.pooled > 0.2 && held.pooled < 3 && held.high <= 0.06 * regime.draws &&
         held.low <= 0.15 * regime.draws;
}

TEST(Regimes, MeasuredErrorsAreWithinAFactorOfTheirLaw) {
  for (int i = 0; i < kRegimes; ++i) {
    const RegimeHeld held = HoldLaw(static_cast<Regime>(i), 100, 40, 31,
                                    [](const RegimeDraw& draw) { return LawOf(draw); });
    EXPECT_EQ(held.draws, 100) << NameOf(held.regime);
    for (const Held& each : {held.along_surface, held.in_image}) {
      EXPECT_EQ(each.low + each.high, 0)
          << NameOf(held.regime) << ": " << each.least << " to " << each.most;
      EXPECT_NEAR(each.median, 1, 0.1) << NameOf(held.regime);
      EXPECT_NEAR(each.pooled, 1, 0.2) << NameOf(held.regime);
    }
  }
}

// Each rounding counts to two hundredths: a rounding that is left out changes one of these numbers,
// of meshes and worlds whose origin is far from the cut.
TEST(Regimes, EachRoundingCounts) {
  Camera camera;
  camera.near = 0.1, camera.far = 100, camera.yaw = 0.3, camera.pitch = -0.2, camera.roll = 0.1;
  const auto error = [&](PlaneSpace space, double of_mesh, double of_world,
                         const std::function<void(runtime::DrawMatrices&)>& change) {
    Camera there = camera;
    const double direction[3] = {0.8, -0.5, 0.33};
    for (int i = 0; i < 3; ++i) there.eye[i] = direction[i] * of_world;
    const Matrix to_world = there.ViewToWorld();
    runtime::DrawMatrices draw = {harness::Rotation(1.1, 0.4, -0.7), there.View(),
                                  there.Projection()};
    double place[3] = {0.3, -0.2, 0.1};
    for (int i = 0; i < 3 && of_mesh > 0; ++i) place[i] = direction[i] * of_mesh;
    for (int j = 0; j < 3; ++j) {
      draw.world.m[3][j] = 10 * to_world.m[2][j] + to_world.m[3][j];
      for (int i = 0; i < 3; ++i) draw.world.m[3][j] -= place[i] * draw.world.m[i][j];
    }
    change(draw);
    return PredictEdgeError(space, {0.4, 0.5, 0.77, -7.7}, runtime::KnownIn::kView, draw,
                            {place, 1, 0.1}, kImageHeight)
        .value;
  };
  const auto once = [](runtime::DrawMatrices&) {};
  const auto product = [](runtime::DrawMatrices& draw) {
    draw.order = MatrixOrder::kFloatWorldView;
  };
  const auto is = [](double value, double expected) {
    EXPECT_NEAR(value / expected, 1, 0.02) << expected;
  };
  is(error(PlaneSpace::kClip, 1000, 0, once), 3.65);
  camera.infinite = true;  // z and w are sums of the same products
  is(error(PlaneSpace::kClip, 0, 0, once), 0.0772);
  is(error(PlaneSpace::kXyw1, 0, 0, once), 0.00055);
  is(error(PlaneSpace::kClip, 1000, 0, once), 1.37);
  is(error(PlaneSpace::kClip, 1e7, 0, once), 11334);  // they are the same in float
  is(error(PlaneSpace::kXyw1, 0, 1000, product), 0.0433);
  is(error(PlaneSpace::kXyw1, 0, 1000, [](auto& draw) { draw.order = MatrixOrder::kWorldFirst; }),
     0.0422);
}

// How far the middle place of a cut is from the origin of the space that `to_view` transforms from,
// in heights of the image.
double ReachOf(const Setup& setup, const Matrix& to_view) {
  std::vector<double> reaches;
  for (const Vector& place : RandomCuts(setup, 63)) {
    const Vector away = place - OriginInView(to_view);
    reaches.push_back(std::sqrt(Dot(away, away)) / (2 * setup.config.camera.HalfHeightAt(place.z)));
  }
  std::ranges::sort(reaches);
  return reaches.empty() ? 0 : reaches[reaches.size() / 2];
}

// The page of formulas (runtime/plane_space.h, docs/study.md) for a draw.
double ClosedLawOf(const RegimeDraw& draw) {
  const Setup setup = Prepare(draw.config);
  const double own = ReachOf(setup, setup.world_view),
               world = std::max(own, ReachOf(setup, setup.view));
  const auto law = [&](PlaneSpace space, double reach) {
    return PredictEdgeError(space, draw.config.view_plane, setup.projection, kImageHeight,
                            draw.sine, reach)
        .value;
  };
  const std::optional<PlaneSpace> space = WayOf(draw.way).space;
  if (draw.way == WayKind::kCpu) {
    // u H R sqrt(1 + tan^2), of the middle place.
    std::vector<double> places;
    for (const Vector& place : RandomCuts(setup, 63)) {
      const Vector away = place - OriginInView(setup.world_view);
      places.push_back(std::sqrt(Dot(away, away)) * std::hypot(place.x, place.y, place.z) /
                       place.z / (2 * draw.config.camera.HalfHeightAt(place.z)));
    }
    std::ranges::sort(places);
    return 1 * 0x1p-24 * kImageHeight * places[places.size() / 2];
  }
  if (!space) return 2 * law(PlaneSpace::kObject, world);
  using enum runtime::MatrixOrder;
  switch (draw.order) {
    case kWorldFirst:
    case kFloatViewProjection: return law(*space, world);
    case kThreeMatrices:
    case kFloatWorldView:
      return std::max(
          law(*space, own),
          law(draw.config.camera.orthographic ? PlaneSpace::kClip : PlaneSpace::kXyw1, world));
    default: return law(*space, own);
  }
}

// The formulas are a page that a reader can follow. They leave out the object's matrix and how the
// cut lies in the image: in the middle of draws they are the followed law.
TEST(Regimes, TheFormulasAgreeWithTheRoundings) {
  for (int i = 0; i < kRegimes; ++i) {
    DrawsOf draws(static_cast<Regime>(i), 77);
    std::vector<double> each;
    for (int draw = 0; draw < 200; ++draw) {
      const RegimeDraw next = draws.Next();
      const double followed = LawOf(next).along_surface;
      if (followed > 0 && followed < 20) each.push_back(ClosedLawOf(next) / followed);
    }
    std::ranges::sort(each);
    ASSERT_GT(each.size(), 50u);
    const auto at = [&](double share) {
      return each[static_cast<std::size_t>(share * static_cast<double>(each.size() - 1))];
    };
    EXPECT_NEAR(at(0.5), 1, 0.4) << NameOf(static_cast<Regime>(i));
    EXPECT_GT(at(0.05), 0.14) << NameOf(static_cast<Regime>(i));
    EXPECT_LT(at(0.95), 5) << NameOf(static_cast<Regime>(i));
  }
}

// So is that of the vertices, for an object where the world matrix puts it.
TEST(Regimes, TheFormulaOfVerticesAgreesWithTheRoundings) {
  for (const Regime regime :
       {Regime::kOneMatrix, Regime::kWorldFirst, Regime::kWorldViewFirst, Regime::kThreeMatrices,
        Regime::kFloatWorldView, Regime::kFloatViewProjection}) {
    DrawsOf draws(regime, 78);
    std::vector<double> each;
    for (int draw = 0; draw < 200; ++draw) {
      const RegimeDraw next = draws.Next();
      const double followed = LawOf(next).of_vertices;
      if (!(followed > 0 && followed < 20)) continue;
      const auto setup = Prepare(next.config);
      const auto constant =
          PlaneConstantFor(PlaneSpace::kObject, setup.world_plane, runtime::KnownIn::kWorld,
                           {setup.world, setup.view, setup.projection, next.order}, {kImageHeight});
      each.push_back(constant.value.vertex_error / followed);
    }
    std::ranges::sort(each);
    ASSERT_GT(each.size(), 50u);
    EXPECT_NEAR(each[each.size() / 2], 1, 0.4) << NameOf(regime);
    EXPECT_GT(each[each.size() / 20], 0.14) << NameOf(regime);
    EXPECT_LT(each[each.size() * 19 / 20], 5) << NameOf(regime);
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
    return !NearlyHolds(HoldLaw(regime, 60, 30, 33, Without(change)));
  };
  EXPECT_TRUE(breaks(Regime::kMeshOffset, [](RegimeDraw& d) { d.config.mesh_offset = 0; }));
  for (const auto& [regime, taken_for] : {std::pair{Regime::kWorldFirst, MatrixOrder::kOneMatrix},
                                          {Regime::kWorldViewFirst, MatrixOrder::kWorldFirst},
                                          {Regime::kThreeMatrices, MatrixOrder::kOneMatrix},
                                          {Regime::kFloatWorldView, MatrixOrder::kOneMatrix},
                                          {Regime::kFloatViewProjection, MatrixOrder::kOneMatrix}})
    EXPECT_TRUE(breaks(regime, [order = taken_for](RegimeDraw& d) { d.order = order; }))
        << NameOf(regime);
  EXPECT_TRUE(breaks(Regime::kWorldSpace, [](RegimeDraw& d) { d.way = WayKind::kObject; }));
  // The law is that of an eye in the plane, where depth begins.
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
