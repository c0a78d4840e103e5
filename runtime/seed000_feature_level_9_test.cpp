// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// "User clip planes on feature level 9 hardware" (Microsoft), what a run-time test can say of each
// section. Where the document errs, the test says what is right.
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/box_planner.h"
#include "runtime/clip_plane.h"
#include "runtime/clip_status.h"
#include "runtime/level9_binder.h"
#include "runtime/table.h"
#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

using ::testing::HasSubstr;

// A position somewhere before the camera, and the view-space point it belongs to.
struct Vertex {
  double view[4] = {0, 0, 0, 1};
  double clip[4] = {};
};

Vertex RandomVertex(Random& random, const Camera& camera) {
  Vertex vertex;
  const double far = std::isinf(camera.far) ? 1000 : camera.far;
  const auto v = ViewPoint(camera, random.Between(-1, 1), random.Between(-1, 1),
                           random.Between(std::max(0.1, camera.near), far));
  for (int i = 0; i < 4; ++i) vertex.view[i] = v[i];
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) vertex.clip[j] += v[i] * camera.projection.m[i][j];
  }
  return vertex;
}

UserClipPlanes OnePlane(const Float4& plane) { return {{{plane.x, plane.y, plane.z, plane.w}}, 1}; }

bool IsClipped(float x, float y, float z, float w, const Float4& plane) {
  return (ClipCode({x, y, z, w}, OnePlane(plane)) & kClipPlane0) != 0;
}

TEST(Seed000Background, TheNegativeSideOfAnyPlaneIsClipped) {
  const UserClipPlanes user = {{{1, 0, 0, 0}, {0, 1, 0, 0}}, 3};
  EXPECT_EQ(ClipCode({0.5f, 0.5f, 0.5f, 1}, user), 0u);
  EXPECT_NE(ClipCode({-0.5f, 0.5f, 0.5f, 1}, user), 0u);
  EXPECT_NE(ClipCode({0.5f, -0.5f, 0.5f, 1}, user), 0u);
}

std::string BinaryTable(unsigned char planes) {
  std::string bytes = {
      0x35, 0x28, 0, 0, static_cast<char>(3 + 2 * planes), 0, 0, 0, static_cast<char>(planes),
      0,    0,    0};
  for (char i = 0; i < static_cast<char>(planes); ++i) bytes += {0, 0, i, 0, 1, 0, 0, 0};
  return bytes;
}

TEST(Seed000Syntax, UpToSixPlanes) {
  const std::string six = BinaryTable(6), seven = BinaryTable(7);
  EXPECT_TRUE(ReadTable(six.data(), six.size()).ok());
  const Result<Table> table = ReadTable(seven.data(), seven.size());
  EXPECT_EQ(table.status.error(), Error::kDamagedTable);
  EXPECT_THAT(table.status.message(), HasSubstr("7"));
}

TEST(Seed000SyntaxNote, APlaneOfZerosNoLongerAffectsAnyGeometry) {
  Random random(1);
  const Float4 zero;
  for (int i = 0; i < 1000; ++i) {
    const auto number = [&] {
      return static_cast<float>(random.Between(-1, 1) * random.Magnitude(1e-30, 1e30));
    };
    EXPECT_FALSE(IsClipped(number(), number(), number(), number(), zero));
  }
  EXPECT_EQ(PlanBox({{-9, -9, -9}, {9, 9, 9}}, &zero, 1), 0);
  // The document does not say: only of finite vertices. 0 * infinity is NaN, and NaN clips.
  EXPECT_TRUE(IsClipped(INFINITY, 0, 0, 1, zero));
}

class CountingDevice final : public ClipDevice {
 public:
  bool SetClipPlane(std::uint32_t index, const float plane[4]) noexcept override {
    ++calls, last_index = index, last_x = plane[0];
    return true;
  }
  bool SetClipPlaneEnable(std::uint32_t mask) noexcept override {
    enabled = mask;
    return true;
  }
  int calls = 0;
  std::uint32_t last_index = 99, enabled = 0;
  float last_x = 0;
};

TEST(Seed000TenLevel9FeatureLevels, TheTableIsEnoughToCallSetClipPlane) {
  const std::string bytes = BinaryTable(2);
  const Result<Table> table = ReadTable(bytes.data(), bytes.size());
  ASSERT_TRUE(table.ok());
  const float constants[2][4] = {{1, 0, 0, 0}, {2, 0, 0, 0}};
  const BoundBuffer buffer = {0, 0, constants, sizeof constants};
  CountingDevice device;
  Level9Binder binder(device, 6);
  ASSERT_TRUE(binder.Bind(table.value, &buffer, 1).ok());
  EXPECT_EQ(device.calls, 2);
  EXPECT_EQ(device.last_index, 1u);
  EXPECT_EQ(device.last_x, 2);
  EXPECT_EQ(device.enabled, 3u);
}

TEST(Seed000TenLevel9FeatureLevels, ClipSpaceIsBeforeThePerspectiveDivision) {
  // x >= 2 in clip space, at w = 4 and at w = 1.
  EXPECT_FALSE(IsClipped(3, 0, 0, 4, {1, 0, 0, -0.5f}));
  EXPECT_TRUE(IsClipped(0.4f, 0, 0, 1, {1, 0, 0, -0.5f}));
}

TEST(Seed000ClipPlaneMath, PixelsOnTheVectorsSideAreKept) {
  EXPECT_FALSE(IsClipped(0, 1, 0, 1, {0, 1, 0, 0}));
  EXPECT_TRUE(IsClipped(0, -1, 0, 1, {0, 1, 0, 0}));
  EXPECT_FALSE(IsClipped(5, 0, 5, 1, {0, 1, 0, 0}))
      << "the plane runs through the origin, and what lies on it is kept";
}

TEST(Seed000ClipPlaneMath, PositiveWClipsLessAndNegativeWMore) {
  EXPECT_FALSE(IsClipped(0, -0.5f, 0, 1, {0, 1, 0, 1}));
  EXPECT_TRUE(IsClipped(0, 0.5f, 0, 1, {0, 1, 0, -1}));
}

// The document: w pushes the plane w units back. Right only for a unit vector; in general by w /
// |n|.
TEST(Seed000ClipPlaneMath, WMovesThePlaneByItselfOverTheLengthOfTheNormal) {
  EXPECT_FALSE(IsClipped(0, -0.99f, 0, 1, {0, 1, 0, 1}));
  EXPECT_TRUE(IsClipped(0, -1.01f, 0, 1, {0, 1, 0, 1}));
  EXPECT_FALSE(IsClipped(0, -1.4f, 0, 1, {0, 2, 0, 3})) << "the plane is at y = -1.5, not at -3";
  EXPECT_TRUE(IsClipped(0, -1.6f, 0, 1, {0, 2, 0, 3}));
}

// The document dots the vertex (x, y, z, 1). Right in view space; in clip space it is (x, y, z, w).
TEST(Seed000ClipPlaneMath, TheVertexInClipSpaceHasItsOwnW) {
  Random random(2);
  const Camera camera = PerspectiveCamera(0.1, 100);
  int wrong_with_one = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vertex v = RandomVertex(random, camera);
    Plane view = random.PlaneAt(0);
    view.w = -view.z * 20;
    const Plane clip = ClipPlaneFromView(view, camera.projection).value.plane;
    const double d = Dot(view, v.view);
    if (std::fabs(d) < 1e-6) continue;
    EXPECT_EQ(Dot(clip, v.clip) >= 0, d >= 0);
    wrong_with_one += (Dot(clip, {v.clip[0], v.clip[1], v.clip[2], 1}) >= 0) != (d >= 0);
  }
  EXPECT_GT(wrong_with_one, 500);
}

TEST(Seed000ClippingInViewSpace, TheClipDistanceIsTheDotProduct) {
  EXPECT_EQ(Dot({2, 3, 5, 7}, {11, 13, 17, 1}), 2 * 11 + 3 * 13 + 5 * 17 + 7);
}

TEST(Seed000ProjectionMatrix, TheSimplifiedMatrix) {
  Random random(3);
  const Camera camera = PerspectiveCamera(0.1, 100);
  const ProjectionShape shape = ShapeOf(camera.projection);
  ASSERT_TRUE(shape.is_perspective());
  const Vertex v = RandomVertex(random, camera);
  EXPECT_EQ(v.clip[0], v.view[0] * shape.px);
  EXPECT_EQ(v.clip[1], v.view[1] * shape.py);
  EXPECT_EQ(v.clip[2], v.view[2] * shape.a + shape.b);
  EXPECT_EQ(v.clip[3], v.view[2]);
}

// "Other projections require different math": the closed form refuses them, and the general
// function does not.
TEST(Seed000ProjectionMatrix, OtherProjectionsRequireDifferentMath) {
  Random random(4);
  for (const Camera& camera : AllCameras()) {
    const Matrix& m = camera.projection;
    int wrong = 0, wrong_document = 0, judged = 0;
    for (int i = 0; i < 2000; ++i) {
      Plane view = random.PlaneAt(0);
      view.w = -camera.forward * view.z * random.Between(1, 50);
      const Plane general = ClipPlaneFromView(view, m).value.plane;
      const Plane document = {view.x / m.m[0][0], view.y / m.m[1][1], view.w / m.m[3][2],
                              view.z - view.w * m.m[2][2] / m.m[3][2]};
      const Vertex v = RandomVertex(random, camera);
      const double d = Dot(view, v.view);
      if (std::fabs(d) < 1e-6 * (1 + std::fabs(v.view[2]))) continue;
      ++judged;
      wrong += (Dot(general, v.clip) >= 0) != (d >= 0);
      wrong_document += (Dot(document, v.clip) >= 0) != (d >= 0);
    }
    EXPECT_EQ(wrong, 0) << camera.name;
    const bool is_accepted = DocumentClipPlane({0, 0, 1, -1}, m).ok();
    EXPECT_EQ(is_accepted, camera.perspective && camera.forward == 1 && m.m[2][0] == 0)
        << camera.name;
    if (is_accepted) {
      EXPECT_EQ(wrong_document, 0) << camera.name;
    }
    if (camera.forward == -1 && camera.perspective) {
      EXPECT_GT(wrong_document, judged / 10) << camera.name;
    }
  }
}

TEST(Seed000ClipSpaceClipPlane, GivesTheSameDotProduct) {
  Random random(5);
  const Camera camera = PerspectiveCamera(0.1, 100);
  for (int i = 0; i < 1000; ++i) {
    const Plane view = random.PlaneAt(random.Between(-20, 20));
    const Result<PlaneConstant> clip = DocumentClipPlane(view, camera.projection);
    ASSERT_TRUE(clip.ok());
    const Vertex v = RandomVertex(random, camera);
    EXPECT_NEAR(Dot(clip.value.plane, v.clip), Dot(view, v.view), 1e-9);
  }
}

// The document writes A_y in the last equation; it is the scalar A of the matrix, as in the result
// below it.
TEST(Seed000ClipSpaceClipPlane, TheFourEquations) {
  const Camera camera = PerspectiveCamera(0.25, 64);
  const ProjectionShape p = ShapeOf(camera.projection);
  const Plane c = {0.5, -0.25, 0.75, -3};
  const Plane cp = DocumentClipPlane(c, camera.projection).value.plane;
  EXPECT_DOUBLE_EQ(cp.x, c.x / p.px);
  EXPECT_DOUBLE_EQ(cp.y, c.y / p.py);
  EXPECT_DOUBLE_EQ(cp.z, c.w / p.b);
  EXPECT_DOUBLE_EQ(cp.w, c.z - c.w * p.a / p.b);
  // With 0 <= z <= w, A/B = -1/n: the last component is the distance of the near plane's centre
  // over n.
  EXPECT_DOUBLE_EQ(cp.w, (c.z * 0.25 + c.w) / 0.25);
}

}  // namespace
}  // namespace clipc::runtime
