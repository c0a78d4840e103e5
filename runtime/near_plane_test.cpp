// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/near_plane.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/clip_plane.h"
#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

using ::testing::HasSubstr;

struct Position {
  double x = 0, y = 0, z = 0, w = 0;
};

Position Project(const std::vector<double>& v, const Matrix& m) {
  Position p;
  double* const to[] = {&p.x, &p.y, &p.z, &p.w};
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) *to[j] += v[i] * m.m[i][j];
  }
  return p;
}

bool PassesNear(const Position& p, DepthRange range) {
  if (range.reversed) return p.z <= p.w;
  return range.negative_one_to_one ? p.z >= -p.w : p.z >= 0;
}

bool PassesFar(const Position& p, DepthRange range, double slack) {
  if (range.reversed) return range.negative_one_to_one ? p.z >= -p.w - slack : p.z >= -slack;
  return p.z <= p.w + slack;
}

// 0 at the near plane, 1 at the far plane.
double Depth(const Position& p, DepthRange range) {
  const double z = p.z / p.w, low = range.negative_one_to_one ? -1 : 0;
  return range.reversed ? (1 - z) / (1 - low) : (z - low) / (1 - low);
}

double FarOf(const Camera& camera) { return std::isinf(camera.far) ? 1e5 : camera.far; }

// A plane at `distance` before the eye, tilted, with the eye on the clipped side.
Plane TiltedPlane(const Camera& camera, double tilt, double distance) {
  return {std::sin(tilt) * 0.6, std::sin(tilt) * 0.8, camera.forward * std::cos(tilt), -distance};
}

TEST(NearPlane, ClipsByThePlaneAndNothingElse) {
  Random random(1);
  for (const Camera& camera : AllCameras()) {
    for (const double tilt : {0.0, 0.5, 1.0}) {
      const Plane plane = TiltedPlane(camera, tilt, 2);
      const Result<ShearedProjection> sheared =
          ShearNearPlane(plane, camera.projection, camera.range, NearPlaneScale::kKeepFar);
      ASSERT_TRUE(sheared.ok()) << camera.name << ": " << sheared.status.message();
      EXPECT_TRUE(sheared.value.keeps_far);
      int kept = 0;
      for (int i = 0; i < 500; ++i) {
        const double s = random.Magnitude(std::max(camera.near, 0.01), FarOf(camera));
        const auto v = ViewPoint(camera, random.Between(-1, 1), random.Between(-1, 1), s);
        const double d = Dot(plane, {v[0], v[1], v[2], 1});
        if (std::fabs(d) < 1e-6) continue;
        const Position p = Project(v, sheared.value.projection),
                       plain = Project(v, camera.projection);
        EXPECT_EQ(PassesNear(p, camera.range), d > 0) << camera.name;
        if (d > 0) {
          EXPECT_TRUE(PassesFar(p, camera.range, 1e-9 * p.w)) << camera.name;
        }
        EXPECT_EQ(p.x, plain.x);
        EXPECT_EQ(p.y, plain.y);
        EXPECT_EQ(p.w, plain.w);
        kept += d > 0;
      }
      EXPECT_GT(kept, 20) << camera.name;
    }
  }
}

TEST(NearPlane, LengyelsScaleIsTheLargest) {
  for (const Camera& camera : AllCameras()) {
    const Plane plane = TiltedPlane(camera, 0.5, 2);
    const ShearedProjection sheared =
        ShearNearPlane(plane, camera.projection, camera.range, NearPlaneScale::kKeepFar).value;
    double deepest = 0;
    for (const double x : {-1, 1}) {
      for (const double y : {-1, 1}) {
        const auto v = ViewPoint(camera, x, y, std::isinf(camera.far) ? 1e9 : camera.far);
        deepest = std::max(deepest, Depth(Project(v, sheared.projection), camera.range));
      }
    }
    EXPECT_NEAR(deepest, 1, 1e-6) << camera.name << ": one far corner is exactly on the far plane";
  }
}

TEST(NearPlane, DepthGrowsAlongEveryLineOfSightAtThePromisedRate) {
  Random random(2);
  for (const Camera& camera : AllCameras()) {
    const Plane plane = TiltedPlane(camera, 0.4, 3);
    const ShearedProjection sheared =
        ShearNearPlane(plane, camera.projection, camera.range, NearPlaneScale::kKeepFar).value;
    for (int i = 0; i < 100; ++i) {
      const double x = random.Between(-1, 1), y = random.Between(-1, 1), s = random.Between(5, 20);
      const auto v = ViewPoint(camera, x, y, s), farther = ViewPoint(camera, x, y, s * 1.001);
      const double plain = Depth(Project(farther, camera.projection), camera.range) -
                           Depth(Project(v, camera.projection), camera.range);
      const double growth = Depth(Project(farther, sheared.projection), camera.range) -
                            Depth(Project(v, sheared.projection), camera.range);
      EXPECT_GT(growth, 0) << camera.name;
      if (camera.far < 1e5) {
        EXPECT_NEAR(growth / plain, sheared.depth_ratio, 1e-6 * sheared.depth_ratio) << camera.name;
      }
      if (camera.perspective) {  // dz/ds = a|Cw| / s^2
        EXPECT_NEAR(growth, sheared.effective_near * (1 / s - 1 / (s * 1.001)), 1e-12)
            << camera.name;
      }
    }
  }
}

TEST(NearPlane, TheNearPlaneItselfChangesNothing) {
  for (const Camera& camera : AllCameras()) {
    if (camera.near == 0) continue;
    const Result<ShearedProjection> sheared =
        ShearNearPlane({0, 0, camera.forward, -camera.near}, camera.projection, camera.range,
                       NearPlaneScale::kKeepFar);
    ASSERT_TRUE(sheared.ok()) << camera.name << ": " << sheared.status.message();
    EXPECT_NEAR(sheared.value.depth_ratio, 1, 1e-8);
    for (int row = 0; row < 4; ++row) {
      EXPECT_NEAR(sheared.value.projection.m[row][2], camera.projection.m[row][2], 1e-8)
          << camera.name;
    }
  }
}

TEST(NearPlane, TheEyeMustBeClipped) {
  for (const Camera& camera : AllCameras()) {
    for (const NearPlaneScale scale : {NearPlaneScale::kAsGiven, NearPlaneScale::kKeepFar}) {
      const auto error = [&](const Plane& plane) {
        return ShearNearPlane(plane, camera.projection, camera.range, scale).status.error();
      };
      EXPECT_EQ(error({0, 0, -camera.forward, 2}), Error::kEyeNotClipped) << camera.name;
      EXPECT_EQ(error({}), Error::kEyeNotClipped) << "the zero plane";
      if (camera.perspective) {
        EXPECT_EQ(error({0, 1, 0, 0}), Error::kEyeNotClipped) << "a plane through the eye";
        EXPECT_EQ(error({0, 0, camera.forward, 1e-9}), Error::kEyeNotClipped);
      } else {
        EXPECT_EQ(error({0, 1, 0, -1}), Error::kEyeNotClipped)
            << "a plane along the direction of view";
      }
    }
  }
}

TEST(NearPlane, ThePlaneMustNotBeNearerThanTheNearPlane) {
  for (const Camera& camera : AllCameras()) {
    if (!camera.perspective) continue;
    const auto shear = [&](double distance) {
      return ShearNearPlane({0, 0, camera.forward, -distance}, camera.projection, camera.range,
                            NearPlaneScale::kAsGiven);
    };
    EXPECT_TRUE(shear(camera.near).ok()) << camera.name;
    const Result<ShearedProjection> nearer = shear(camera.near * 0.99);
    EXPECT_EQ(nearer.status.error(), Error::kNoDepthLeft) << camera.name;
    EXPECT_THAT(nearer.status.message(), HasSubstr("near plane"));
  }
  // Water that an orthographic camera sees from almost exactly the side.
  const Camera flat = OrthographicCamera(0.1, 100);
  EXPECT_EQ(
      ShearNearPlane({0, 1, 1e-6, 0}, flat.projection, {}, NearPlaneScale::kKeepFar).status.error(),
      Error::kNoDepthLeft);
}

TEST(NearPlane, ScaleOfThePlaneOnlyMattersAsGiven) {
  const Camera camera = PerspectiveCamera(0.1, 100);
  const auto shear = [&](double length, NearPlaneScale scale) {
    return ShearNearPlane({0, 0.6 * length, 0.8 * length, -2 * length}, camera.projection, {},
                          scale)
        .value;
  };
  const ShearedProjection one = shear(1, NearPlaneScale::kKeepFar),
                          ten = shear(10, NearPlaneScale::kKeepFar);
  EXPECT_NEAR(one.effective_near, ten.effective_near, 1e-12);
  EXPECT_NEAR(one.depth_ratio, ten.depth_ratio, 1e-12);
  EXPECT_NEAR(one.scale, 10 * ten.scale, 1e-12);
  EXPECT_TRUE(shear(0.5, NearPlaneScale::kAsGiven).keeps_far);
  EXPECT_FALSE(shear(10, NearPlaneScale::kAsGiven).keeps_far);
  EXPECT_EQ(shear(10, NearPlaneScale::kAsGiven).effective_near, 20);
}

TEST(NearPlane, APlaneThatClipsTheWholeFrustum) {
  for (const Camera& camera : AllCameras()) {
    if (std::isinf(camera.far)) continue;
    const Plane behind = {0, 0, camera.forward, -2 * camera.far};
    const Result<ShearedProjection> sheared =
        ShearNearPlane(behind, camera.projection, camera.range, NearPlaneScale::kKeepFar);
    ASSERT_TRUE(sheared.ok()) << camera.name << ": " << sheared.status.message();
    EXPECT_TRUE(sheared.value.keeps_far);
    const auto v = ViewPoint(camera, 0.3, 0.3, camera.far / 2);
    EXPECT_FALSE(PassesNear(Project(v, sheared.value.projection), camera.range)) << camera.name;
  }
}

TEST(NearPlane, AScaleBeyondADoubleIsRefused) {
  Matrix infinite = PerspectiveCamera(0.1, 100).projection;
  infinite.m[2][2] = 0, infinite.m[3][2] = 0.1;
  const auto error = [&](double slope) {
    return ShearNearPlane({0, 0, slope, -1}, infinite, {.reversed = true}, NearPlaneScale::kKeepFar)
        .status.error();
  };
  EXPECT_EQ(error(5e-324), Error::kNotRepresentable);
  EXPECT_EQ(error(1e-300), Error::kNone);
}

TEST(NearPlane, TheDepthColumnOfAnObjectsMatrix) {
  Random random(3);
  for (const Camera& camera : AllCameras()) {
    const Plane plane = TiltedPlane(camera, 0.5, 2);
    const ShearedProjection sheared =
        ShearNearPlane(plane, camera.projection, camera.range, NearPlaneScale::kKeepFar).value;
    const Matrix world_view = random.Rigid(3);
    Matrix to_clip = Multiply(world_view, camera.projection);
    SetDepthColumn(to_clip, PlaneBefore(world_view, plane), sheared.scale, camera.range);
    const Matrix expected = Multiply(world_view, sheared.projection);
    for (int i = 0; i < 16; ++i)
      EXPECT_NEAR(to_clip.m[i / 4][i % 4], expected.m[i / 4][i % 4], 1e-12) << camera.name;
  }
}

TEST(NearPlane, ProjectionsThatContradictTheirDepthRange) {
  const Plane plane = {0, 0, 1, -2};
  const auto error = [&](const Camera& camera, DepthRange range) {
    return ShearNearPlane(plane, camera.projection, range, NearPlaneScale::kKeepFar).status.error();
  };
  EXPECT_EQ(error(PerspectiveCamera(0.1, 100), {false, true}), Error::kWrongProjection);
  EXPECT_EQ(error(PerspectiveCamera(0.1, 100, {false, true}), {}), Error::kWrongProjection);
  Camera tilted = PerspectiveCamera(0.1, 100);
  tilted.projection.m[0][1] = 0.1;
  EXPECT_EQ(error(tilted, {}), Error::kWrongProjection);
  Camera broken = PerspectiveCamera(0.1, 100);
  broken.projection.m[3][2] = 0;
  EXPECT_EQ(error(broken, {}), Error::kSingular);
  broken.projection.m[3][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error(broken, {}), Error::kNotFinite);
  EXPECT_EQ(ShearNearPlane({0, 0, NAN, 1}, PerspectiveCamera(0.1, 100).projection, {},
                           NearPlaneScale::kKeepFar)
                .status.error(),
            Error::kNotFinite);
}

// The formula that ShearedProjection::effective_near states, on an unsheared projection.
TEST(NearPlane, DepthStepOfTheStandardProjection) {
  const double near = 0.1, s = 30, step = s * s / near * 0x1p-24;
  const Camera camera = PerspectiveCamera(near, INFINITY);
  const double before = Depth(Project(ViewPoint(camera, 0, 0, s), camera.projection), {});
  const double after = Depth(Project(ViewPoint(camera, 0, 0, s + step), camera.projection), {});
  EXPECT_NEAR((after - before) * 0x1p24, 1, 1e-3);
}

}  // namespace
}  // namespace clipc::runtime
