// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// "Custom Clip Plane Using Near Clip Plane Shearing" (NVIDIA, WP-01386-001), section by section.
// Where the paper errs, the test says what is right.
#include <cmath>

#include <gtest/gtest.h>

#include "runtime/clip_plane.h"
#include "runtime/near_plane.h"
#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

// The paper's matrix: the projection, then the identity with the clip-space plane in its z column.
Matrix PapersProjection(const Matrix& projection, const Plane& view_plane) {
  const Plane plane = ClipPlaneFromView(view_plane, projection).value.plane;
  Matrix to_custom;
  to_custom.m[0][2] = plane.x, to_custom.m[1][2] = plane.y, to_custom.m[2][2] = plane.z,
  to_custom.m[3][2] = plane.w;
  return Multiply(projection, to_custom);
}

// The part that the far test loses of what is visible before the plane, between 0 and 1.
double LostAtFar(const Camera& camera, const Plane& plane, const Matrix& projection) {
  Random random(1);
  int visible = 0, lost = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto v = ViewPoint(camera, random.Between(-1, 1), random.Between(-1, 1),
                             random.Magnitude(0.1, 1000) * 0.999);
    if (Dot(plane, {v[0], v[1], v[2], 1}) < 0) continue;
    double z = 0, w = 0;
    for (int k = 0; k < 4; ++k) z += v[k] * projection.m[k][2], w += v[k] * projection.m[k][3];
    ++visible;
    lost += z > w;
  }
  return static_cast<double>(lost) / visible;
}

TEST(Seed004CodeSample, TheShearedProjectionIsThePapers) {
  const Camera camera = PerspectiveCamera(0.1, 1000);
  const Plane plane = {0, 0.6, 0.8, -2};
  const Result<ShearedProjection> sheared =
      ShearNearPlane(plane, camera.projection, camera.range, NearPlaneScale::kAsGiven);
  ASSERT_TRUE(sheared.ok()) << sheared.status.message();
  const Matrix paper = PapersProjection(camera.projection, plane);
  for (int i = 0; i < 16; ++i)
    EXPECT_NEAR(sheared.value.projection.m[i / 4][i % 4], paper.m[i / 4][i % 4], 1e-12);
}

// "Assigned the z axis of an identity matrix": with row vectors it is the z column.
TEST(Seed004CodeSample, TheZColumnIsThePlane) {
  const Camera camera = PerspectiveCamera(0.1, 1000);
  const Plane plane = {0.36, 0.48, 0.8, -2};
  const Matrix paper = PapersProjection(camera.projection, plane);
  EXPECT_NEAR(paper.m[0][2], plane.x, 1e-12);
  EXPECT_NEAR(paper.m[1][2], plane.y, 1e-12);
  EXPECT_NEAR(paper.m[2][2], plane.z, 1e-12);
  EXPECT_NEAR(paper.m[3][2], plane.w, 1e-12);
}

// Note 1, "you must normalize your transform": what a plane needs is the inverse transpose, which
// the code computes. Nothing is normalised, and a plane of any length cuts the same.
TEST(Seed004DetailsNote1, PlanesGoThroughTheInverseTranspose) {
  Random random(2);
  const Matrix view = random.Rigid(5);
  const Camera camera = PerspectiveCamera(0.1, 1000);
  for (int i = 0; i < 200; ++i) {
    const Plane in_view = random.PlaneAt(random.Between(-5, 5));
    const Plane world = PlaneBefore(view, in_view);
    const Plane clip = ClipPlaneFromWorld(world, view, camera.projection).value.plane;
    const Plane back = PlaneBefore(Multiply(view, camera.projection),
                                   clip);  // the transpose of the inverse, undone
    EXPECT_NEAR(back.x, world.x, 1e-9);
    EXPECT_NEAR(back.y, world.y, 1e-9);
    EXPECT_NEAR(back.z, world.z, 1e-9);
    EXPECT_NEAR(back.w, world.w, 1e-9);
  }
}

// The far plane does depend on the plane's length, which the paper's own scale leaves to chance.
TEST(Seed004DetailsNote1, TheLengthOfThePlaneDecidesWhatTheFarPlaneLoses) {
  const Camera camera = PerspectiveCamera(0.1, 1000);
  const auto lost = [&](double length) {
    const Plane plane = {0.6 * length, 0.6 * length, 0.52915 * length, -2 * length};
    return LostAtFar(camera, plane, PapersProjection(camera.projection, plane));
  };
  EXPECT_EQ(lost(0.1), 0);
  EXPECT_NEAR(lost(1), 0.117, 0.02);
  EXPECT_NEAR(lost(10), 0.914, 0.02);
}

TEST(Seed004DetailsNote1, LengyelsScaleLosesNothingWhateverTheLength) {
  const Camera camera = PerspectiveCamera(0.1, 1000);
  for (const double length : {0.1, 1.0, 10.0}) {
    const Plane plane = {0.6 * length, 0.6 * length, 0.52915 * length, -2 * length};
    const Result<ShearedProjection> sheared =
        ShearNearPlane(plane, camera.projection, camera.range, NearPlaneScale::kKeepFar);
    ASSERT_TRUE(sheared.ok());
    EXPECT_EQ(LostAtFar(camera, plane, sheared.value.projection), 0);
    const Result<ShearedProjection> as_given =
        ShearNearPlane(plane, camera.projection, camera.range, NearPlaneScale::kAsGiven);
    ASSERT_TRUE(as_given.ok());
    EXPECT_EQ(as_given.value.keeps_far, length == 0.1);
  }
}

// Note 2, the plane must face away from the eye, else flip it. Flipping keeps the other half of the
// scene, and not flipping inverts every depth test; so such a plane is refused.
TEST(Seed004DetailsNote2, AnEyeOnTheKeptSideIsRefused) {
  const Camera camera = PerspectiveCamera(0.1, 1000);
  const Plane plane = {0, 0.6, 0.8, 2};
  EXPECT_EQ(ShearNearPlane(plane, camera.projection, camera.range, NearPlaneScale::kAsGiven)
                .status.error(),
            Error::kEyeNotClipped);
  EXPECT_EQ(ShearNearPlane(plane, camera.projection, camera.range, NearPlaneScale::kKeepFar)
                .status.error(),
            Error::kEyeNotClipped);
  const Matrix paper = PapersProjection(camera.projection, plane);
  const auto depth = [&](double s) {
    const auto v = ViewPoint(camera, 0.1, 0.1, s);
    double z = 0, w = 0;
    for (int k = 0; k < 4; ++k) z += v[k] * paper.m[k][2], w += v[k] * paper.m[k][3];
    return z / w;
  };
  EXPECT_GT(depth(5), depth(10)) << "what is farther would hide what is nearer";
}

// The sample asks projClipPlane.w, as if it were the side of the eye. It is the side of the
// clip-space point (0, 0, 0, 1): the near plane's centre for 0 <= z <= w, and a point beyond the
// near plane for -w <= z <= w.
TEST(Seed004DetailsNote2, TheSignOfWIsNotTheSideOfTheEye) {
  const Plane plane = {0, 0, 1, -0.15};  // the eye and the near plane, at 0.1, are clipped
  const Camera direct3d = PerspectiveCamera(0.1, 100),
               opengl = PerspectiveCamera(0.1, 100, {true, false});
  EXPECT_LT(ClipPlaneFromView(plane, direct3d.projection).value.plane.w, 0);
  EXPECT_GT(ClipPlaneFromView(plane, opengl.projection).value.plane.w, 0)
      << "the sample would flip this plane";
  EXPECT_TRUE(
      ShearNearPlane(plane, opengl.projection, opengl.range, NearPlaneScale::kAsGiven).ok());

  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const Plane any = random.PlaneAt(random.Between(-0.3, 0.3));
    const double near_centre = Dot(any, {0, 0, 0.1, 1});
    EXPECT_NEAR(ClipPlaneFromView(any, direct3d.projection).value.plane.w, near_centre / 0.1, 1e-9);
  }
}

// Note 3, the far plane changes, "unless you have an infinite clip distance": an infinite far plane
// changes nothing.
TEST(Seed004DetailsNote3, AnInfiniteFarPlaneLosesAsMuch) {
  const Plane plane = {0.6, 0.6, 0.52915, -2};
  const Camera finite = PerspectiveCamera(0.1, 1000), infinite = PerspectiveCamera(0.1, INFINITY);
  const double lost = LostAtFar(finite, plane, PapersProjection(finite.projection, plane));
  EXPECT_GT(lost, 0.09);
  EXPECT_EQ(LostAtFar(infinite, plane, PapersProjection(infinite.projection, plane)), lost);
  EXPECT_FALSE(
      ShearNearPlane(plane, infinite.projection, {}, NearPlaneScale::kAsGiven).value.keeps_far);
  EXPECT_TRUE(
      ShearNearPlane(plane, infinite.projection, {}, NearPlaneScale::kKeepFar).value.keeps_far);
}

// A single plane, and never switched off by zeros: they would give every point the same depth.
TEST(Seed004NearClipPlane, ThePlaneOfZerosIsNoPlane) {
  const Camera camera = PerspectiveCamera(0.1, 1000);
  EXPECT_EQ(
      ShearNearPlane({}, camera.projection, camera.range, NearPlaneScale::kKeepFar).status.error(),
      Error::kEyeNotClipped);
}

}  // namespace
}  // namespace clipc::runtime
