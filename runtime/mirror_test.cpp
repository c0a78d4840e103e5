// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/mirror.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "runtime/clip_plane.h"
#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

void Transform(const double (&v)[4], const Matrix& matrix, double (&to)[4]) {
  for (int j = 0; j < 4; ++j) {
    to[j] = 0;
    for (int i = 0; i < 4; ++i) to[j] += v[i] * matrix.m[i][j];
  }
}

TEST(MirrorMatrixTest, MirrorsInThePlane) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    Plane plane = random.PlaneAt(random.Between(-9, 9));
    const double scale = random.Magnitude(0.1, 10) * (random.Below(2) == 0 ? 1 : -1);
    plane = {plane.x * scale, plane.y * scale, plane.z * scale, plane.w * scale};
    const Matrix mirror = MirrorMatrix(plane).value;
    const double point[4] = {random.Between(-9, 9), random.Between(-9, 9), random.Between(-9, 9),
                             1};
    double image[4], back[4];
    Transform(point, mirror, image);
    Transform(image, mirror, back);
    EXPECT_NEAR(Dot(plane, image), -Dot(plane, point), 1e-12 * std::fabs(scale) * 30)
        << "as far behind the plane";
    const double n[3] = {plane.x, plane.y, plane.z};
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(back[j], point[j], 1e-12);
      EXPECT_NEAR(image[j] - point[j], -2 * Dot(plane, point) / (scale * scale) * n[j], 1e-12)
          << "along the normal";
    }
    EXPECT_EQ(image[3], 1);
  }
}

TEST(MirrorMatrixTest, Water) {
  const Matrix mirror = MirrorMatrix({0, 1, 0, -2}).value;  // y = 2
  double image[4];
  Transform({5, 3, 7, 1}, mirror, image);
  EXPECT_EQ(image[0], 5);
  EXPECT_EQ(image[1], 1);
  EXPECT_EQ(image[2], 7);
}

TEST(MirrorMatrixTest, TheMirroredViewKeepsWhatIsAboveTheWater) {
  Random random(2);
  const Plane water = {0, 1, 0, -2};
  const Matrix view = random.Rigid(5), mirrored = Multiply(MirrorMatrix(water).value, view);
  for (const Camera& camera : AllCameras()) {
    const Result<PlaneConstant> plane = ClipPlaneFromWorld(water, mirrored, camera.projection);
    ASSERT_TRUE(plane.ok()) << plane.status.message();
    const Matrix to_clip = Multiply(mirrored, camera.projection);
    for (int i = 0; i < 100; ++i) {
      const double point[4] = {random.Between(-9, 9), random.Between(-9, 9), random.Between(-9, 9),
                               1};
      double position[4];
      Transform(point, to_clip, position);
      EXPECT_EQ(Dot(plane.value.plane, position) >= 0, point[1] >= 2) << camera.name;
    }
  }
}

TEST(MirrorMatrixTest, AnyLengthOfTheNormalWillDo) {
  for (const double scale : {1e-300, 1e-310, 1.7e308}) {
    const Matrix mirror = MirrorMatrix({scale, scale, 0, scale}).value;
    EXPECT_NEAR(mirror.m[0][1], -1, 1e-12) << scale;
    EXPECT_NEAR(mirror.m[3][0], -1, 1e-12) << scale;
  }
  EXPECT_NEAR(MirrorMatrix({1.7e308, 1.7e308, 0, 1}).value.m[0][1], -1, 1e-15);
  // The plane x = -1e310.
  EXPECT_EQ(MirrorMatrix({1e-300, 0, 0, 1e10}).status.error(), Error::kNotRepresentable);
}

TEST(MirrorMatrixTest, PlanesThatCannotMirror) {
  EXPECT_EQ(MirrorMatrix({0, 0, 0, 1}).status.error(), Error::kSingular);
  for (const double bad :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(MirrorMatrix({bad, 1, 1, 1}).status.error(), Error::kNotFinite);
    EXPECT_EQ(MirrorMatrix({1, bad, 1, 1}).status.error(), Error::kNotFinite);
    EXPECT_EQ(MirrorMatrix({1, 1, bad, 1}).status.error(), Error::kNotFinite);
    EXPECT_EQ(MirrorMatrix({1, 1, 1, bad}).status.error(), Error::kNotFinite);
  }
}

}  // namespace
}  // namespace clipc::runtime
