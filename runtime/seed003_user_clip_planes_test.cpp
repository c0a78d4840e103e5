// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// "What Are User-defined Clip Planes?" (Microsoft). The document contradicts SetClipPlane's page
// and its own images in several places; each test says what is right.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/clip_plane.h"
#include "runtime/clip_status.h"
#include "runtime/level9_binder.h"
#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

struct Point {
  float x, y, z;
};

// A round object about the origin, with points exactly on the coordinate planes.
std::vector<Point> Teapot() {
  std::vector<Point> points;
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const Plane p = random.PlaneAt(0);
    points.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    if (i % 10 == 0) points.back().x = 0;
    if (i % 10 == 1) points.back().y = 0;
    if (i % 10 == 2) points.back().z = 0;
  }
  return points;
}

bool IsKept(const Point& p, std::initializer_list<Float4> planes) {
  UserClipPlanes user;
  for (const Float4& plane : planes) {
    const std::uint32_t i = user.enable_mask == 0 ? 0 : 1;
    user.planes[i][0] = plane.x, user.planes[i][1] = plane.y, user.planes[i][2] = plane.z,
    user.planes[i][3] = plane.w;
    user.enable_mask |= 1u << i;
  }
  return (ClipCode({p.x, p.y, p.z, 1}, user) & ~std::uint32_t{kClipPlane0 - 1}) == 0;
}

// The document: points on or behind the plane are clipped. Right: those behind; on the plane is
// visible.
TEST(Seed003Inequality, PointsOnThePlaneAreVisible) {
  EXPECT_TRUE(IsKept({0, 0.5f, 0.5f}, {{1, 0, 0, 0}}));
  EXPECT_TRUE(IsKept({0, 0.5f, 0.5f}, {{-1, 0, 0, 0}}));
  EXPECT_TRUE(IsKept({0.25f, 0.5f, 0.5f}, {{4, 2, 0, -2}}));
}

// The formula is missing in the document: Ax + By + Cz + D >= 0 is visible.
TEST(Seed003Inequality, VisibleIsGreaterOrEqualZero) {
  for (const Point& p : Teapot()) {
    EXPECT_EQ(IsKept(p, {{0.5f, -0.25f, 2, 0.125f}}),
              0.5f * p.x - 0.25f * p.y + 2 * p.z + 0.125f >= 0);
  }
}

// The document: clips all vertices at x >= 0. Right: at x > 0.
TEST(Seed003LeftTeapot, ClipsWhatHasPositiveX) {
  for (const Point& p : Teapot()) EXPECT_EQ(IsKept(p, {{-1, 0, 0, 0}}), p.x <= 0);
}

// The document: (1, 0, 1, 0) clips all vertices at z >= 0. Right: it is a diagonal plane that keeps
// x + z >= 0.
TEST(Seed003RightTeapot, IsCutDiagonally) {
  int front = 0, front_kept = 0, back = 0, back_kept = 0;
  for (const Point& p : Teapot()) {
    const bool is_kept = IsKept(p, {{1, 0, 1, 0}});
    EXPECT_EQ(is_kept, p.x + p.z >= 0);
    (p.z >= 0 ? front : back) += 1;
    (p.z >= 0 ? front_kept : back_kept) += is_kept;
    EXPECT_EQ(IsKept(p, {{0, 0, -1, 0}}), p.z <= 0) << "the plane that the document means";
  }
  EXPECT_GT(front_kept, front / 2);
  EXPECT_GT(back_kept, back / 10);
}

// The document: the union of the half-spaces. Right: the intersection, as its image shows.
TEST(Seed003TwoPlanes, TheRenderedAreaIsTheIntersection) {
  int both = 0, either = 0, all = 0;
  for (const Point& p : Teapot()) {
    const Float4 right = {1, 0, 0, 0}, lower = {0, -1, 0, 0};
    const bool is_kept = IsKept(p, {right, lower});
    EXPECT_EQ(is_kept, p.x >= 0 && p.y <= 0);
    both += is_kept;
    either += IsKept(p, {right}) || IsKept(p, {lower});
    ++all;
  }
  EXPECT_LT(both, 2 * all / 5);
  EXPECT_GT(either, 3 * all / 5);
}

class NoDevice final : public ClipDevice {
 public:
  bool SetClipPlane(std::uint32_t, const float*) noexcept override { return true; }
  bool SetClipPlaneEnable(std::uint32_t) noexcept override { return true; }
};

// The document: up to 32 planes, see wMaxUserClipPlanes of DirectX 7. Right for Direct3D 9:
// D3DCAPS9::MaxUserClipPlanes, and no more than the six that D3DCS_PLANE0 to D3DCS_PLANE5 can tell.
TEST(Seed003Limits, TheDeviceSaysHowManyPlanesThereAre) {
  Table table;
  table.enable_mask = 0x7F;
  table.planes.resize(7);
  const float constants[4] = {};
  const BoundBuffer buffer = {0, 0, constants, sizeof constants};
  NoDevice device;
  Level9Binder binder(device, 32);
  EXPECT_EQ(binder.Bind(table, &buffer, 1).error(), Error::kInvalidCall);
  table.enable_mask = 0x3F;
  EXPECT_TRUE(binder.Bind(table, &buffer, 1).ok());
  Level9Binder small(device, 3);
  EXPECT_EQ(small.Bind(table, &buffer, 1).error(), Error::kInvalidCall);
}

// The document: planes are in world space. Right only for the fixed-function pipeline; a plane for
// a vertex shader's device goes to clip space first, and then keeps the same points.
TEST(Seed003Space, WorldSpacePlanesGoToClipSpace) {
  Random random(2);
  const Matrix view = random.Rigid(0);
  for (const Camera& camera : AllCameras()) {
    Matrix far_view = view;
    far_view.m[3][2] += camera.forward * 5;
    const Matrix to_clip = Multiply(far_view, camera.projection);
    const Plane world = {0.6, 0.64, -0.48, 0.1};
    const Result<PlaneConstant> clip = ClipPlaneFromWorld(world, far_view, camera.projection);
    ASSERT_TRUE(clip.ok());
    int differs_unconverted = 0;
    for (const Point& p : Teapot()) {
      const double v[4] = {static_cast<double>(p.x), static_cast<double>(p.y),
                           static_cast<double>(p.z), 1};
      double position[4] = {};
      for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) position[j] += v[i] * to_clip.m[i][j];
      }
      const double d = Dot(world, v);
      if (std::fabs(d) < 1e-9) continue;
      EXPECT_EQ(Dot(clip.value.plane, position) >= 0, d >= 0) << camera.name;
      differs_unconverted += (Dot(world, position) >= 0) != (d >= 0);
    }
    EXPECT_GT(differs_unconverted, 100) << camera.name;
  }
}

}  // namespace
}  // namespace clipc::runtime
