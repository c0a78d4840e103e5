// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What a plane's odd values and odd triangles do on a real clipper, for each way that can be given
// them.
#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "study/program/studio.h"
#include "study/sweeps.h"

namespace clipc::study {
namespace {

class Special : public ::testing::Test {
 protected:
  // Fragments drawn of the mesh with one plane.
  double Fragments(WayKind kind, const Mesh& mesh, const WayConstants& constants) {
    const auto call = MakeCall(studio_.gl(), kind, kind == WayKind::kNone ? 0 : 1, true);
    call->SetMesh(mesh);
    call->SetConstants(constants);
    studio_.Begin();
    call->Draw();
    double sum = 0;
    for (const float count : studio_.Counts()) sum += static_cast<double>(count);
    return sum;
  }

  WayConstants With(const study::Setup& setup, const Vec4<float>& plane) const {
    return {ConvertTo<float>(setup.world_view_projection), ConvertTo<float>(setup.world), {plane}};
  }

  draw::Device device_;
  Studio studio_{device_, 320, 180, true};
  const study::Setup setup_ = Prepare(ObliqueAt(4));
  const Mesh knot_ = TorusKnot(120, 12, 1.3);
};

constexpr WayKind kShaders[] = {
    WayKind::kClip,    WayKind::kXyw1,          WayKind::kObject,           WayKind::kWorld,
    WayKind::kDiscard, WayKind::kDiscardObject, WayKind::kDiscardRecomputed};

TEST_F(Special, AZeroPlaneClipsNothing) {
  const double all = Fragments(WayKind::kNone, knot_, With(setup_, {}));
  ASSERT_GT(all, 5000);
  for (const WayKind kind : kShaders) {
    EXPECT_EQ(Fragments(kind, knot_, With(setup_, {{0, 0, 0, 0}})), all) << static_cast<int>(kind);
    EXPECT_EQ(Fragments(kind, knot_, With(setup_, {{-0.0f, 0, 0, -0.0f}})), all)
        << static_cast<int>(kind);
    EXPECT_EQ(Fragments(kind, knot_, With(setup_, {{0, 0, 0, -1}})) == all, false)
        << static_cast<int>(kind);  // the test can fail
  }
  EXPECT_EQ(Fragments(WayKind::kLevel9, knot_, With(setup_, {})), all);
}

TEST_F(Special, NotANumberClipsEverything) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const WayKind kind : kShaders) {
    EXPECT_EQ(Fragments(kind, knot_, With(setup_, {{kNan, 0, 0, 1}})), 0) << static_cast<int>(kind);
  }
}

// A knot around the eye: its triangles pass through w = 0. What a plane keeps and what its opposite
// keeps is all there is.
TEST_F(Special, TrianglesThroughTheEyesPlane) {
  const study::Setup& setup = setup_;
  const Mesh around = TorusKnot(120, 12, 6);
  int behind = 0;
  for (const Vec4<float>& vertex : around.vertices)
    behind += Transform(vertex, ConvertTo<float>(setup.world_view_projection))[3] < 0;
  ASSERT_GT(behind, 100);
  const double all = Fragments(WayKind::kNone, around, With(setup, {}));
  for (const WayKind kind :
       {WayKind::kClip, WayKind::kXyw1, WayKind::kObject, WayKind::kWorld, WayKind::kLevel9}) {
    const auto kept = ConstantsOf(kind, setup, {setup.world_plane});
    const runtime::Plane& p = setup.world_plane;
    const auto opposite = ConstantsOf(kind, setup, {runtime::Plane{-p.x, -p.y, -p.z, -p.w}});
    ASSERT_TRUE(kept && opposite);
    const double one = Fragments(kind, around, *kept), other = Fragments(kind, around, *opposite);
    EXPECT_GT(one, 0.05 * all) << static_cast<int>(kind);
    EXPECT_GT(other, 0.05 * all) << static_cast<int>(kind);
    EXPECT_EQ(one + other, all) << static_cast<int>(kind);
  }
}

// Only a clipper antialiases the cut. A square that fills the picture has no other edge in it.
TEST_F(Special, MultisamplingSmoothsTheCutUnlessItIsDiscarded) {
  Mesh square;
  square.vertices = {{{-2, -2, 0, 1}}, {{2, -2, 0, 1}}, {{2, 2, 0, 1}}, {{-2, 2, 0, 1}}};
  square.normals.resize(12);
  square.indices = {0, 1, 2, 0, 2, 3};
  study::Setup setup = setup_;
  setup.world = setup.view = runtime::Matrix{};
  setup.world.m[3][2] = 1;
  setup.world_view = setup.world;
  setup.world_view_projection = runtime::Multiply(setup.world, setup.projection);
  Studio smooth(device_, 320, 180, true, 4);
  for (const WayKind kind : {WayKind::kClip, WayKind::kXyw1, WayKind::kObject, WayKind::kLevel9,
                             WayKind::kDiscard, WayKind::kDiscardRecomputed}) {
    const auto constants = ConstantsOf(kind, setup, {runtime::Plane{1, 0.3, 0, 0.013}});
    ASSERT_TRUE(constants);
    const auto call = MakeCall(smooth.gl(), kind, 1, true);
    call->SetMesh(square);
    call->SetConstants(*constants);
    smooth.Begin();
    call->Draw();
    int whole = 0, partial = 0;
    for (const float count : smooth.Counts())
      whole += count == 1, partial += count > 0 && count < 1;
    const bool discards = kind == WayKind::kDiscard || kind == WayKind::kDiscardRecomputed;
    EXPECT_GT(whole, 20000) << static_cast<int>(kind);
    if (discards) {
      EXPECT_EQ(partial, 0) << static_cast<int>(kind);
    } else {
      EXPECT_GT(partial, 100) << static_cast<int>(kind);
    }
  }
}

}  // namespace
}  // namespace clipc::study
