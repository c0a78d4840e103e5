// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/clip_plane.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double Largest(const Plane& p) {
  return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z), std::fabs(p.w)});
}

// The largest difference, relative to the largest component.
double Difference(const Plane& a, const Plane& b) {
  return Largest({a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w}) / Largest(b);
}

struct WidePlane {
  Wide c[4];
};

WidePlane Widened(const Plane& plane) { return {{plane.x, plane.y, plane.z, plane.w}}; }

// M^-1 c by cofactors in Wide: slow, simple, and not how the product does it.
WidePlane WideAfter(const Matrix& matrix, const WidePlane& plane) {
  const auto& m = matrix.m;
  const auto minor = [&](int row, int column) {
    Wide d[3][3];
    for (int i = 0, r = 0; i < 4; ++i) {
      if (i == row) continue;
      for (int j = 0, c = 0; j < 4; ++j) {
        if (j != column) d[r][c++] = m[i][j];
      }
      ++r;
    }
    const Wide minor = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                       d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                       d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    return (row + column) % 2 == 0 ? minor : -minor;
  };
  Wide determinant = 0;
  WidePlane x = {};
  for (int j = 0; j < 4; ++j) determinant += m[0][j] * minor(0, j);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) x.c[j] += plane.c[i] * minor(i, j);
    x.c[j] /= determinant;
  }
  return x;
}

Plane Narrowed(const WidePlane& plane) {
  return {static_cast<double>(plane.c[0]), static_cast<double>(plane.c[1]),
          static_cast<double>(plane.c[2]), static_cast<double>(plane.c[3])};
}

Plane ExactAfter(const Matrix& matrix, const Plane& plane) {
  return Narrowed(WideAfter(matrix, Widened(plane)));
}

TEST(ClipPlane, EveryProjectionMatchesTheExactSolution) {
  Random random(1);
  for (const Camera& camera : AllCameras()) {
    for (int i = 0; i < 200; ++i) {
      Plane view = random.PlaneAt(random.Between(-1, 1) * random.Magnitude(0.01, 1000));
      if (random.Below(10) == 0) view.w = 0;
      const Result<PlaneConstant> plane = ClipPlaneFromView(view, camera.projection);
      ASSERT_TRUE(plane.ok()) << camera.name << ": " << plane.status.message();
      const double difference = Difference(plane.value.plane, ExactAfter(camera.projection, view));
      // The bound is the promise of `condition`; 8 is for the constant in "about".
      EXPECT_LE(difference, 8 * plane.value.condition * 0x1p-53) << camera.name;
      EXPECT_LT(plane.value.condition, 100) << camera.name;
    }
  }
}

TEST(ClipPlane, SameDotProductInBothSpaces) {
  Random random(2);
  for (const Camera& camera : AllCameras()) {
    const double far = std::isinf(camera.far) ? 1000 : camera.far;
    for (int i = 0; i < 200; ++i) {
      const Plane view = random.PlaneAt(random.Between(-50, 50));
      const Plane clip = ClipPlaneFromView(view, camera.projection).value.plane;
      const auto v = ViewPoint(camera, random.Between(-1, 1), random.Between(-1, 1),
                               random.Between(camera.near, far));
      double position[4] = {}, size = 0;
      const double c[4] = {clip.x, clip.y, clip.z, clip.w};
      for (int j = 0; j < 4; ++j) {
        for (int k = 0; k < 4; ++k)
          position[j] += v[k] * camera.projection.m[k][j],
              size += std::fabs(v[k] * camera.projection.m[k][j] * c[j]);
      }
      EXPECT_NEAR(Dot(clip, position), Dot(view, {v[0], v[1], v[2], v[3]}), 1e-14 * size)
          << camera.name;
    }
  }
}

TEST(ClipPlane, GeneralMatricesMatchTheClosedForm) {
  // A rotation of the image (a tilted display) takes the projection out of the closed form's
  // shape.
  Random random(3);
  for (const Camera& camera : AllCameras()) {
    Matrix tilt;
    tilt.m[0][0] = tilt.m[1][1] = std::cos(0.5);
    tilt.m[1][0] = -(tilt.m[0][1] = std::sin(0.5));
    const Matrix tilted = Multiply(camera.projection, tilt);
    ASSERT_FALSE(ShapeOf(tilted).holds);
    for (int i = 0; i < 100; ++i) {
      const Plane view = random.PlaneAt(random.Between(-50, 50));
      const Result<PlaneConstant> plane = ClipPlaneFromView(view, tilted);
      ASSERT_TRUE(plane.ok()) << plane.status.message();
      EXPECT_LE(Difference(plane.value.plane, ExactAfter(tilted, view)),
                8 * plane.value.condition * 0x1p-53)
          << camera.name;
      EXPECT_LT(plane.value.condition, 1e5) << camera.name;
    }
  }
}

TEST(ClipPlane, WorldAndObjectSpaceGoThroughTheViewMatrix) {
  Random random(4);
  for (const Camera& camera : AllCameras()) {
    for (int i = 0; i < 50; ++i) {
      Matrix world = random.Rigid(10);
      for (auto& row : world.m) row[0] *= 2, row[1] *= 0.5;  // a world that scales unevenly
      const Matrix view = random.Rigid(10);
      const Plane in_view = random.PlaneAt(random.Between(-20, 20));
      const Plane in_world = PlaneBefore(view, in_view), in_object = PlaneBefore(world, in_world);
      const auto after_world = [&](const WidePlane& plane) {
        return Narrowed(WideAfter(camera.projection, WideAfter(view, plane)));
      };
      const Result<PlaneConstant> from_world =
          ClipPlaneFromWorld(in_world, view, camera.projection);
      const Result<PlaneConstant> from_object =
          ClipPlaneFromObject(in_object, world, view, camera.projection);
      ASSERT_TRUE(from_world.ok() && from_object.ok());
      EXPECT_LE(Difference(from_world.value.plane, after_world(Widened(in_world))),
                8 * from_world.value.condition * 0x1p-53)
          << camera.name;
      EXPECT_LE(
          Difference(from_object.value.plane, after_world(WideAfter(world, Widened(in_object)))),
          8 * from_object.value.condition * 0x1p-53)
          << camera.name;
    }
  }
}

// Whether two results are the same, bit for bit and word for word.
bool IsSame(const Result<PlaneConstant>& a, const Result<PlaneConstant>& b) {
  return std::memcmp(&a.value, &b.value, sizeof a.value) == 0 &&
         a.status.error() == b.status.error() &&
         std::strcmp(a.status.message(), b.status.message()) == 0;
}

TEST(ClipPlane, APreparedCameraChangesNoBit) {
  Random random(33);
  int refused = 0;
  for (const Camera& camera : AllCameras()) {
    for (int i = 0; i < 400; ++i) {
      Matrix view = random.Rigid(10), world = random.Rigid(random.Magnitude(1, 1e12));
      Matrix projection = camera.projection;
      Plane plane = random.PlaneAt(random.Between(-20, 20));
      switch (random.Below(12)) {
        case 0: world = random.NearlySingular(2, random.Magnitude(1e-17, 1e-3)); break;
        case 1: view.m[0][0] *= random.Magnitude(1e-200, 1e200); break;
        case 2: projection.m[0][1] = 0.25; break;  // no shape of an API
        case 3: plane.x = random.Magnitude(1e-300, 1e300); break;
        case 4: plane = {}; break;
        case 5: world.m[1][2] = kInfinity; break;
        case 6: plane.w = kNan; break;
        case 7: std::fill(view.m[1], view.m[1] + 3, 0); break;  // no inverse
        case 8: projection.m[3][2] = projection.m[2][2] = 0; break;
        case 9: std::swap(world.m[0][3], world.m[3][0]); break;
        default: break;
      }
      const Result<PreparedCamera> prepared = PrepareCamera(view, projection);
      ASSERT_TRUE(prepared.ok()) << prepared.status.message();
      const auto from_object = ClipPlaneFromObject(plane, world, view, projection);
      EXPECT_TRUE(IsSame(from_object, ClipPlaneFromObject(plane, world, prepared.value)));
      EXPECT_TRUE(IsSame(ClipPlaneFromWorld(plane, view, projection),
                         ClipPlaneFromWorld(plane, prepared.value)));
      refused += from_object.ok() ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 100);
  Matrix bad;
  bad.m[0][3] = 1;
  EXPECT_EQ(PrepareCamera(bad, {}).status.error(), Error::kLooksTransposed);
  bad.m[0][3] = kNan;
  EXPECT_EQ(PrepareCamera(bad, {}).status.error(), Error::kNotFinite);
  EXPECT_EQ(PrepareCamera({}, bad).status.error(), Error::kNotFinite);
}

TEST(ClipPlane, BothMatrixConventionsMeanTheSame) {
  const Camera camera = PerspectiveCamera(0.1, 100, {}, -1, 0.3, -0.2);
  float row_vector[16], column_vector[16];
  for (int i = 0; i < 16; ++i) {
    row_vector[i] = static_cast<float>(camera.projection.m[i / 4][i % 4]);
    column_vector[i] = static_cast<float>(camera.projection.m[i % 4][i / 4]);
  }
  const Matrix a = RowVectorMatrix(row_vector), b = ColumnVectorMatrix(column_vector);
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
  EXPECT_EQ(a.m[3][2], static_cast<double>(static_cast<float>(camera.projection.m[3][2])));
}

TEST(ClipPlane, IsRoundedOnce) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Camera camera = PerspectiveCamera(random.Magnitude(0.01, 1), random.Magnitude(10, 1e5));
    const Result<PlaneConstant> plane =
        ClipPlaneFromView(random.PlaneAt(random.Between(-50, 50)), camera.projection);
    const Plane& p = plane.value.plane;
    EXPECT_EQ(plane.value.constant.z, static_cast<float>(p.z));
    EXPECT_LE(std::fabs(static_cast<double>(plane.value.constant.w) - p.w),
              0x1p-24 * std::fabs(p.w));
  }
}

// g++ 12 with vector instructions once dropped double -> float -> double; then every float result
// here would be a fiction.
TEST(ClipPlane, TheCompilerKeepsRoundings) {
  Random random(6);
  double plain[64], rounded[64];
  for (int i = 0; i < 64; ++i) plain[i] = random.Between(1, 2);
  for (int i = 0; i < 64; i += 4) {
    const Float4 f = RoundPlane({plain[i], plain[i + 1], plain[i + 2], plain[i + 3]}).value;
    const Float4 g = {static_cast<float>(plain[i]), static_cast<float>(plain[i + 1]),
                      static_cast<float>(plain[i + 2]), static_cast<float>(plain[i + 3])};
    EXPECT_EQ(std::memcmp(&f, &g, sizeof f), 0);
    rounded[i] = g.x, rounded[i + 1] = g.y, rounded[i + 2] = g.z, rounded[i + 3] = g.w;
  }
  int changed = 0;
  for (int i = 0; i < 64; ++i) {
    volatile float once = static_cast<float>(plain[i]);
    EXPECT_EQ(rounded[i], static_cast<double>(once));
    changed += rounded[i] != plain[i];
  }
  EXPECT_EQ(changed, 64);
}

TEST(ClipPlane, MatricesWithoutInverse) {
  const Plane plane = {0, 0, 1, -1};
  Matrix flat;  // onto the plane z = 0
  flat.m[2][2] = 0;
  EXPECT_EQ(ClipPlaneFromView(plane, flat).status.error(), Error::kSingular);
  Matrix general = flat;
  general.m[0][1] = 1;
  EXPECT_EQ(ClipPlaneFromView(plane, general).status.error(), Error::kSingular);
  EXPECT_EQ(ClipPlaneFromWorld(plane, flat, {}).status.error(), Error::kSingular);
  EXPECT_THAT(ClipPlaneFromWorld(plane, flat, {}).status.message(), HasSubstr("view matrix"));
  EXPECT_EQ(ClipPlaneFromObject(plane, flat, {}, {}).status.error(), Error::kSingular);
  EXPECT_TRUE(ObjectPlaneFromWorld(plane, flat).ok()) << "no inverse is needed there";
}

TEST(ClipPlane, ResultsThatCannotBeTrusted) {
  // Two rows that differ by 1e-14 of their size.
  Matrix nearly;
  nearly.m[0][1] = 1;
  nearly.m[1][0] = 1, nearly.m[1][1] = 1 + 1e-14;
  const Result<PlaneConstant> result = ClipPlaneFromView({1, 2, 3, 4}, nearly);
  EXPECT_EQ(result.status.error(), Error::kIllConditioned);
  EXPECT_THAT(result.status.message(), HasSubstr("condition"));
}

// Earth-centred coordinates and much farther ones: as right as at the origin.
TEST(ClipPlane, NoOffsetCostsDigits) {
  Random random(7);
  const Camera camera = PerspectiveCamera(0.001, 1000);
  for (const double distance : {0.0, 1e3, 6.4e6, 1e8, 1e12, 1e16}) {
    for (int i = 0; i < 100; ++i) {
      const Matrix view = random.Rigid(distance);
      const Plane in_world = random.PlaneAt(random.Between(-1, 1) * distance);
      const auto plane = ClipPlaneFromWorld(in_world, view, camera.projection);
      ASSERT_TRUE(plane.ok()) << distance << ": " << plane.status.message();
      const Plane exact =
          Narrowed(WideAfter(camera.projection, WideAfter(view, Widened(in_world))));
      EXPECT_LT(Difference(plane.value.plane, exact), 0x1p-48) << distance;
      EXPECT_LT(plane.value.condition, 0x1p10) << distance;
    }
  }
}

TEST(ClipPlane, TransposedMatricesAreNamed) {
  Random random(12);
  const Camera camera = PerspectiveCamera(0.1, 100, {}, 1, 0.2, -0.1);
  const Matrix view = random.Rigid(10), transposed = Transpose(view);
  const Plane plane = {0.6, 0, 0.8, -5};
  const auto error = [](const auto& result) { return result.status.error(); };
  EXPECT_EQ(error(ClipPlaneFromWorld(plane, transposed, camera.projection)),
            Error::kLooksTransposed);
  EXPECT_THAT(ClipPlaneFromWorld(plane, transposed, camera.projection).status.message(),
              HasSubstr("view matrix looks transposed"));
  EXPECT_EQ(error(ClipPlaneFromObject(plane, transposed, view, camera.projection)),
            Error::kLooksTransposed);
  EXPECT_EQ(error(ObjectPlaneFromWorld(plane, transposed)), Error::kLooksTransposed);
  EXPECT_EQ(error(ViewPlaneFromWorld(plane, transposed)), Error::kLooksTransposed);
  for (const Camera& each : AllCameras()) {
    EXPECT_TRUE(CheckProjection(each.projection).ok()) << each.name;
    const Matrix swapped = Transpose(each.projection);
    // A near plane at 1 and no far plane: its transpose is another projection.
    if (each.perspective && std::fabs(each.projection.m[3][2]) == 1) continue;
    EXPECT_EQ(error(ClipPlaneFromView(plane, swapped)), Error::kLooksTransposed) << each.name;
    EXPECT_EQ(error(Xyw1PlaneFromView(plane, swapped)), Error::kLooksTransposed) << each.name;
    EXPECT_EQ(error(DocumentClipPlane(plane, swapped)), Error::kLooksTransposed) << each.name;
  }
}

// Whenever the answer is a plane, it is right to float precision, however bad the matrices are.
TEST(ClipPlane, NeverWrongWithoutSayingSo) {
  Random random(8);
  int trusted = 0, refused = 0;
  for (int i = 0; i < 20000; ++i) {
    const Matrix matrix = random.NearlySingular(3, random.Magnitude(1e-16, 1));
    const Plane plane = random.PlaneAt(random.Between(-9, 9));
    const Result<PlaneConstant> result = ClipPlaneFromView(plane, matrix);
    if (result.ok()) {
      ++trusted;
      EXPECT_LT(Difference(result.value.plane, ExactAfter(matrix, plane)), 0x1p-24)
          << result.value.condition;
    } else {
      ++refused;
      EXPECT_TRUE(result.status.error() == Error::kIllConditioned ||
                  result.status.error() == Error::kSingular);
    }
  }
  EXPECT_GT(trusted, 1000);
  EXPECT_GT(refused, 1000);
}

// Elements so far apart that elimination would lose some without a trace: the right plane is
// (-1, 1, 1, -1), and double arithmetic alone makes (0, 1, 1, -1).
TEST(ClipPlane, ElementsThatUnderflowAreRefused) {
  const Matrix far_apart = {
      {{0, 1e250, -1e250, 0}, {1e-250, 0, 1e-250, 0}, {0, 2, 0, 0}, {1e-250, 1, 0, 1}}};
  EXPECT_EQ(ViewPlaneFromWorld({1, 0, 2, 0}, far_apart).status.error(), Error::kIllConditioned);
  // Products that underflow leave nothing, which is not the plane of zeros.
  const Matrix tiny = {{{1e-200, 0, 0, 0}, {0, 1e-200, 0, 0}, {0, 0, 1e-200, 0}, {0, 0, 0, 1}}};
  EXPECT_FALSE(ObjectPlaneFromWorld({1e-200, 0, 0, 0}, tiny).ok());
  EXPECT_TRUE(ObjectPlaneFromWorld({0, 0, 0, 0}, tiny).ok());
  EXPECT_TRUE(ViewPlaneFromWorld({0, 0, 0, 0}, tiny).ok());
  // One translation of any length, or one scale, is not far apart from anything.
  const Matrix moved = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {1e100, -1e100, 3, 1}}};
  EXPECT_TRUE(ViewPlaneFromWorld({0, 0, 1, 2}, moved).ok());
}

TEST(ClipPlane, NumbersThatAreNotFinite) {
  const Camera camera = PerspectiveCamera(0.1, 100);
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int i = 0; i < 4; ++i) {
      Plane plane = {1, 2, 3, 4};
      (i == 0 ? plane.x : i == 1 ? plane.y : i == 2 ? plane.z : plane.w) = bad;
      for (const auto& result :
           {ClipPlaneFromView(plane, camera.projection),
            Xyw1PlaneFromView(plane, camera.projection), ObjectPlaneFromWorld(plane, {}),
            DocumentClipPlane(plane, camera.projection)}) {
        EXPECT_EQ(result.status.error(), Error::kNotFinite);
        EXPECT_THAT(result.status.message(), HasSubstr("has a coefficient that is not finite"));
      }
    }
    for (int i = 0; i < 16; ++i) {
      Matrix matrix;
      matrix.m[i / 4][i % 4] = bad;
      EXPECT_EQ(ClipPlaneFromView({1, 0, 0, 0}, matrix).status.error(), Error::kNotFinite);
      EXPECT_EQ(ClipPlaneFromWorld({1, 0, 0, 0}, matrix, {}).status.error(), Error::kNotFinite);
      EXPECT_EQ(ObjectPlaneFromWorld({1, 0, 0, 0}, matrix).status.error(), Error::kNotFinite);
    }
  }
}

TEST(ClipPlane, PlanesTooLargeOrTooSmallForFloat) {
  const Camera camera = PerspectiveCamera(0.1, 100);
  const auto scaled = [&](double scale) {
    return ClipPlaneFromView({scale, 0, 0, scale}, camera.projection).status.error();
  };
  EXPECT_EQ(scaled(1e-28), Error::kNone);
  EXPECT_EQ(scaled(1e-33), Error::kNotRepresentable);
  EXPECT_EQ(scaled(1e32), Error::kNone);
  EXPECT_EQ(scaled(1e34), Error::kNotRepresentable);
  EXPECT_EQ(scaled(1e300), Error::kNotRepresentable);
  EXPECT_EQ(scaled(1.7e308), Error::kNotFinite);  // divided by 0.97, of the projection
}

TEST(ClipPlane, TheZeroPlaneStaysZero) {
  for (const Camera& camera : AllCameras()) {
    const Result<PlaneConstant> plane = ClipPlaneFromView({}, camera.projection);
    ASSERT_TRUE(plane.ok());
    EXPECT_EQ(Largest(plane.value.plane), 0);
  }
}

TEST(DocumentClipPlaneTest, OnlyForTheDocumentsMatrix) {
  Random random(9);
  for (const Camera& camera : AllCameras()) {
    const Plane view = random.PlaneAt(-3);
    const Result<PlaneConstant> plane = DocumentClipPlane(view, camera.projection);
    const auto& m = camera.projection.m;
    const bool is_the_documents = camera.perspective && camera.forward == 1 && m[2][0] == 0;
    EXPECT_EQ(plane.status.error(), is_the_documents ? Error::kNone : Error::kWrongProjection)
        << camera.name;
    if (!is_the_documents) continue;
    const double a = m[2][2], b = m[3][2];
    const Plane formula = {view.x / m[0][0], view.y / m[1][1], view.w / b, view.z - view.w * a / b};
    EXPECT_LT(Difference(plane.value.plane, formula), 1e-15) << camera.name;
  }
  // Each other element.
  for (const int i : {1, 2, 3, 4, 6, 7, 8, 9, 12, 13, 15}) {
    Matrix other = PerspectiveCamera(0.1, 100).projection;
    other.m[i / 4][i % 4] = 0.5;
    EXPECT_EQ(DocumentClipPlane({0, 0, 1, -3}, other).status.error(), Error::kWrongProjection) << i;
  }
  Matrix flat = PerspectiveCamera(0.1, 100).projection;
  flat.m[3][2] = 0;
  EXPECT_EQ(DocumentClipPlane({0, 0, 1, -3}, flat).status.error(), Error::kWrongProjection);
}

TEST(Xyw1Plane, SameDistanceWithoutZ) {
  Random random(10);
  for (const Camera& camera : AllCameras()) {
    const Plane view = random.PlaneAt(random.Between(-20, 20));
    const Result<PlaneConstant> k = Xyw1PlaneFromView(view, camera.projection);
    ASSERT_EQ(k.status.error(), camera.perspective ? Error::kNone : Error::kWrongProjection)
        << camera.name;
    if (!camera.perspective) continue;
    for (int i = 0; i < 50; ++i) {
      const auto v = ViewPoint(camera, random.Between(-1, 1), random.Between(-1, 1),
                               random.Magnitude(0.1, 1000));
      double p[4] = {};
      for (int j = 0; j < 4; ++j) {
        for (int r = 0; r < 4; ++r) p[j] += v[r] * camera.projection.m[r][j];
      }
      EXPECT_NEAR(Dot(k.value.plane, {p[0], p[1], p[3], 1}), Dot(view, {v[0], v[1], v[2], 1}),
                  1e-12 * (1 + std::fabs(v[2])))
          << camera.name;
    }
  }
  Matrix shifted = PerspectiveCamera(0.1, 100).projection;
  shifted.m[3][0] = 1;
  EXPECT_EQ(Xyw1PlaneFromView({1, 0, 0, 0}, shifted).status.error(), Error::kWrongProjection);
  std::swap(shifted.m[3][0], shifted.m[3][1]);
  EXPECT_EQ(Xyw1PlaneFromView({1, 0, 0, 0}, shifted).status.error(), Error::kWrongProjection);
}

TEST(ObjectPlane, SameDistanceWhateverTheOffset) {
  Random random(11);
  for (const double offset : {0.0, 1e3, 1e7, 1e12}) {
    Matrix world = random.Rigid(0);
    world.m[3][0] = offset, world.m[3][1] = -offset, world.m[3][2] = offset / 3;
    const Plane in_world = {0.6, -0.48, 0.64,
                            -0.6 * offset - 0.48 * offset - 0.64 * offset / 3 + 0.5};
    const Result<PlaneConstant> plane = ObjectPlaneFromWorld(in_world, world);
    ASSERT_TRUE(plane.ok());
    for (int i = 0; i < 4; ++i) {
      Wide exact = static_cast<Wide>(world.m[i][0]) * in_world.x +
                   static_cast<Wide>(world.m[i][1]) * in_world.y;
      exact += static_cast<Wide>(world.m[i][2]) * in_world.z +
               static_cast<Wide>(world.m[i][3]) * in_world.w;
      const Plane& p = plane.value.plane;
      const double component = i == 0 ? p.x : i == 1 ? p.y : i == 2 ? p.z : p.w;
      EXPECT_LE(std::fabs(component - static_cast<double>(exact)),
                0x1p-52 * std::fabs(static_cast<double>(exact)))
          << offset;
    }
  }
}

}  // namespace
}  // namespace clipc::runtime
