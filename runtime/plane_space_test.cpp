// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/plane_space.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

using ::testing::HasSubstr;

struct Vertex {
  Wide object[4], view[4], clip[4];
};

// v * m, exact enough to compare with double.
void Transform(const Wide (&v)[4], const Matrix& m, Wide (&to)[4]) {
  for (int j = 0; j < 4; ++j) {
    to[j] = 0;
    for (int i = 0; i < 4; ++i) to[j] += v[i] * m.m[i][j];
  }
}

Vertex VertexAt(Random& random, const DrawMatrices& draw) {
  Vertex vertex = {
      {random.Between(-5, 5), random.Between(-5, 5), random.Between(-5, 5), 1}, {}, {}};
  Wide world[4];
  Transform(vertex.object, draw.world, world);
  Transform(world, draw.view, vertex.view);
  Transform(vertex.view, draw.projection, vertex.clip);
  return vertex;
}

// The position that a shader of that space dots with the plane.
void PositionIn(PlaneSpace space, const Vertex& vertex, Wide (&p)[4]) {
  const Wide xyw1[4] = {vertex.clip[0], vertex.clip[1], vertex.clip[3], 1};
  for (int i = 0; i < 4; ++i) {
    p[i] = space == PlaneSpace::kObject ? vertex.object[i]
           : space == PlaneSpace::kXyw1 ? xyw1[i]
                                        : vertex.clip[i];
  }
}

constexpr PlaneSpace kSpaces[] = {PlaneSpace::kClip, PlaneSpace::kXyw1, PlaneSpace::kObject};

// Every way from a plane to a constant means the same plane, in every convention.
TEST(PlaneConstantFor, MeansTheSamePlaneEverywhere) {
  Random random(11);
  int checked = 0;
  for (const Camera& camera : AllCameras()) {
    for (int round = 0; round < 40; ++round) {
      const DrawMatrices draw = {random.Rigid(10), random.Rigid(10), camera.projection};
      const Plane object = random.PlaneAt(random.Between(-3, 3));
      const Plane world = ViewPlaneFromWorld(object, draw.world).value.plane;
      const Plane view = ViewPlaneFromWorld(world, draw.view).value.plane;
      const Vertex vertex = VertexAt(random, draw);
      Wide expected = 0;
      const double c[4] = {object.x, object.y, object.z, object.w};
      for (int i = 0; i < 4; ++i) expected += vertex.object[i] * c[i];
      for (const PlaneSpace space : kSpaces) {
        for (const auto& [plane, known_in] :
             {std::pair{object, KnownIn::kObject}, std::pair{world, KnownIn::kWorld},
              std::pair{view, KnownIn::kView}}) {
          const Result<SpaceConstant> result = PlaneConstantFor(space, plane, known_in, draw);
          if (space == PlaneSpace::kXyw1 && !camera.perspective) {
            EXPECT_EQ(result.status.error(), Error::kWrongProjection) << camera.name;
            continue;
          }
          ASSERT_TRUE(result.ok()) << camera.name << ": " << result.status.message();
          const Plane& got = result.value.plane.plane;
          const double k[4] = {got.x, got.y, got.z, got.w};
          Wide p[4], value = 0, size = 0;
          PositionIn(space, vertex, p);
          for (int i = 0; i < 4; ++i) {
            value += p[i] * k[i];
            size += (p[i] < 0 ? -p[i] : p[i]) * std::fabs(k[i]);
          }
          EXPECT_NEAR(static_cast<double>(value), static_cast<double>(expected),
                      1e-13 * static_cast<double>(size))
              << camera.name << ' ' << NameOf(space);
          EXPECT_EQ(result.value.plane.constant.x, static_cast<float>(got.x));
          ++checked;
        }
      }
    }
  }
  EXPECT_GT(checked, 10000);
}

TEST(PlaneConstantFor, WarnsWhereTheDefaultLosesPixels) {
  // |Cw| / n = 300 / 0.1.
  const Camera camera = PerspectiveCamera(0.1, 1e6);
  const DrawMatrices draw = {{}, {}, camera.projection};
  const Plane plane = {0, 0, -1, 300};
  const auto clip = PlaneConstantFor(PlaneSpace::kClip, plane, KnownIn::kView, draw);
  ASSERT_TRUE(clip.ok());
  // 10 * 2^-24 * 540 * (1 + 2.73 + 1.4 * 3000 * 2.73).
  EXPECT_NEAR(clip.value.edge_error, 3.694, 0.001);
  EXPECT_EQ(clip.value.warning.error(), Error::kIllConditioned);
  EXPECT_THAT(clip.value.warning.message(),
              HasSubstr("plane space clip displaces the cut by about 3.7 pixels of 1080 rows"));
  EXPECT_THAT(clip.value.warning.message(), HasSubstr("--plane-space=xyw1"));
  EXPECT_TRUE(PlaneConstantFor(PlaneSpace::kClip, plane, KnownIn::kView, draw, {1080, 3.8})
                  .value.warning.ok());
  EXPECT_DOUBLE_EQ(PlaneConstantFor(PlaneSpace::kClip, plane, KnownIn::kView, draw, {2160, 3.8})
                       .value.edge_error,
                   2 * clip.value.edge_error);
  for (const PlaneSpace space : {PlaneSpace::kXyw1, PlaneSpace::kObject}) {
    const auto other = PlaneConstantFor(space, plane, KnownIn::kView, draw);
    ASSERT_TRUE(other.ok());
    EXPECT_TRUE(other.value.warning.ok());
    EXPECT_LT(other.value.edge_error, 0.002);
  }
  const DrawMatrices reversed = {{}, {}, PerspectiveCamera(0.1, 1e6, {false, true}).projection};
  EXPECT_TRUE(
      PlaneConstantFor(PlaneSpace::kClip, plane, KnownIn::kView, reversed).value.warning.ok());
}

// A narrow view has no cure that holds for every draw.
TEST(PlaneConstantFor, NamesNoCureOfANarrowView) {
  const DrawMatrices draw = {{}, {}, PerspectiveCamera(0.1, 1e6, {}, 1, 0, 0, 0.05).projection};
  const auto xyw1 = PlaneConstantFor(PlaneSpace::kXyw1, {0, 0, -1, 300}, KnownIn::kView, draw);
  EXPECT_EQ(xyw1.value.warning.error(), Error::kIllConditioned);
  EXPECT_THAT(xyw1.value.warning.message(), ::testing::EndsWith("rows"));
}

// A sun's shadow map: neither xyw1 nor reversed depth is a cure there.
TEST(PlaneConstantFor, NamesTheCureOfAnOrthographicView) {
  DrawMatrices draw = {{}, {}, OrthographicCamera(100, 60000).projection};
  const Plane plane = {0, 0.6, -0.8, 20000};
  const auto clip = PlaneConstantFor(PlaneSpace::kClip, plane, KnownIn::kView, draw);
  ASSERT_TRUE(clip.ok());
  EXPECT_EQ(clip.value.warning.error(), Error::kIllConditioned);
  EXPECT_THAT(clip.value.warning.message(), HasSubstr("; use --plane-space=object"));
  EXPECT_TRUE(
      PlaneConstantFor(PlaneSpace::kObject, plane, KnownIn::kView, draw).value.warning.ok());
}

// The runtime knows the matrices: it counts how far the world's origin is where the shader has the
// vertex in its coordinates.
TEST(PlaneConstantFor, WarnsOfMatricesThatTheShaderMultiplies) {
  DrawMatrices draw = {{}, {}, PerspectiveCamera(0.1, 1000).projection};
  draw.world.m[3][0] = 1e4, draw.world.m[3][2] = 10;
  draw.view.m[3][0] = -1e4;
  const Plane plane = {0.6, 0, 0.8, -8 - 6e3};
  for (const PlaneSpace space : kSpaces) {
    draw.order = MatrixOrder::kOneMatrix;
    const auto one = PlaneConstantFor(space, plane, KnownIn::kWorld, draw);
    ASSERT_TRUE(one.ok());
    EXPECT_TRUE(one.value.warning.ok()) << one.value.warning.message();
    draw.order = MatrixOrder::kWorldFirst;
    const auto two = PlaneConstantFor(space, plane, KnownIn::kWorld, draw);
    EXPECT_EQ(two.value.warning.ok(), space == PlaneSpace::kObject);
    if (space == PlaneSpace::kObject) continue;
    EXPECT_GT(two.value.edge_error, 100 * one.value.edge_error);
    EXPECT_THAT(two.value.warning.message(), HasSubstr("let the world begin at the camera"));
  }
  // The cure: the world begins at the camera.
  draw.world.m[3][0] = 0, draw.view.m[3][0] = 0;
  EXPECT_TRUE(PlaneConstantFor(PlaneSpace::kXyw1, {0.6, 0, 0.8, -8}, KnownIn::kWorld, draw)
                  .value.warning.ok());
}

// One matrix, which the application multiplied in float, is not better.
TEST(PlaneConstantFor, WarnsOfMatricesThatWereMultipliedInFloat) {
  DrawMatrices draw = {{}, {}, PerspectiveCamera(0.1, 1000).projection};
  draw.world.m[3][0] = 1e4, draw.world.m[3][2] = 10;
  draw.view.m[3][0] = -1e4;
  const Plane plane = {0.6, 0, 0.8, -8 - 6e3};
  for (const auto order : {MatrixOrder::kFloatWorldView, MatrixOrder::kFloatViewProjection}) {
    draw.order = order;
    for (const PlaneSpace space : kSpaces) {
      const auto made = PlaneConstantFor(space, plane, KnownIn::kWorld, draw);
      EXPECT_EQ(made.value.warning.ok(), space == PlaneSpace::kObject) << NameOf(space);
      if (space == PlaneSpace::kObject) continue;
      EXPECT_THAT(made.value.warning.message(), HasSubstr("multiply its matrices in double"));
    }
  }
}

// The view cancels what is large in the world's coordinates before z and w are made, or after.
TEST(PlaneConstantFor, TheOrderOfMatricesDecides) {
  DrawMatrices draw = {{}, {}, PerspectiveCamera(0.1, 1e4).projection};
  draw.world.m[3][0] = 1e3, draw.world.m[3][2] = 10;
  draw.view.m[3][0] = -1e3;
  const double c = std::cos(0.3), s = std::sin(0.3);
  draw.view = {{{c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0}, {-1e3 * c, 0, -1e3 * s, 1}}};
  const double place[3] = {0.5, 0.1, -0.3};
  const auto both = [&](MatrixOrder order) {
    draw.order = order;
    const Plane plane = {0.6, 0, 0.8, -8};
    const double known =
        PredictEdgeError(PlaneSpace::kClip, plane, KnownIn::kView, draw, {place, 1, 0.1}, 1080)
            .value;
    const double law =
        PlaneConstantFor(PlaneSpace::kClip, plane, KnownIn::kView, draw).value.edge_error;
    EXPECT_GT(law / known, 0.3) << static_cast<int>(order);
    EXPECT_LT(law / known, 3.5) << static_cast<int>(order);
    return known;
  };
  const double one = both(MatrixOrder::kOneMatrix);
  EXPECT_LT(both(MatrixOrder::kWorldViewFirst), 2 * one);
  EXPECT_LT(both(MatrixOrder::kThreeMatrices), 3 * one);
  EXPECT_LT(both(MatrixOrder::kFloatWorldView), 3 * one);
  EXPECT_GT(both(MatrixOrder::kWorldFirst), 10 * one);
  EXPECT_GT(both(MatrixOrder::kFloatViewProjection), 10 * one);
}

// The distance of the world's origin is measured in heights of the image at the depth where the
// world matrix puts the object.
TEST(PlaneConstantFor, CountsTheWorldsOriginFromTheObject) {
  const auto is_law = [](DrawMatrices draw, PlaneSpace law, double reach) {
    const Plane plane = {0.6, 0, 0.8, -8};
    const auto made = PlaneConstantFor(PlaneSpace::kClip, plane, KnownIn::kView, draw);
    ASSERT_TRUE(made.ok()) << made.status.message();
    EXPECT_NEAR(made.value.edge_error /
                    PredictEdgeError(law, plane, draw.projection, 1080, kAnySurface, reach).value,
                1, 1e-12);
  };
  DrawMatrices draw = {{}, {}, PerspectiveCamera(0.1, 1000).projection};
  // The camera turns a quarter to the left: the world's -x is its z.
  draw.view.m[0][2] = -1, draw.view.m[0][0] = 0, draw.view.m[2][0] = 1, draw.view.m[2][2] = 0;
  draw.world.m[3][0] = -2000, draw.world.m[3][1] = 3000, draw.world.m[3][2] = 6000;
  draw.view.m[3][2] = -1990;
  const double at_10 = 7000 * draw.projection.m[1][1] / 20;
  for (const double forward : {1, -1}) {
    DrawMatrices steps = draw;
    steps.order = MatrixOrder::kWorldFirst;
    steps.projection = PerspectiveCamera(0.1, 1000, {}, forward).projection;
    for (auto& row : steps.view.m) row[2] *= forward;
    is_law(steps, PlaneSpace::kClip, at_10);
    for (const double behind : {2000, -1990}) {  // the eye, or beside it
      steps.world.m[3][0] = behind;
      is_law(steps, PlaneSpace::kClip, kAroundOrigin);
    }
    steps.world.m[3][0] = -2000, steps.world.m[3][1] = steps.world.m[3][2] = 0;
    steps.view.m[3][2] = forward * 1e5;  // so far that the world's origin is near the object
    is_law(steps, PlaneSpace::kClip, kAroundOrigin);
  }
  DrawMatrices product = draw;
  product.order = MatrixOrder::kFloatWorldView;
  is_law(product, PlaneSpace::kXyw1, at_10);
  product.world = {};  // the near plane's share is more
  is_law(product, PlaneSpace::kClip, kAroundOrigin);
  DrawMatrices orthographic = draw;
  orthographic.projection = OrthographicCamera(0.1, 100).projection;
  orthographic.order = MatrixOrder::kWorldFirst;
  is_law(orthographic, PlaneSpace::kClip, 7000 * orthographic.projection.m[1][1] / 2);
}

// A float product costs digits under an orthographic projection too, and the prediction that
// follows the cut agrees.
TEST(PlaneConstantFor, WarnsOfAFloatProductUnderAnOrthographicProjection) {
  DrawMatrices draw = {{}, {}, OrthographicCamera(0.1, 100).projection};
  draw.order = MatrixOrder::kFloatWorldView;
  const double c = std::cos(0.4), s = std::sin(0.4);
  draw.view.m[0][0] = c, draw.view.m[0][2] = s, draw.view.m[2][0] = -s, draw.view.m[2][2] = c;
  for (const double away : {1e4, 1e5, 1e6}) {
    draw.world.m[3][0] = 0.7 * away, draw.world.m[3][1] = -0.5 * away, draw.world.m[3][2] = away;
    for (int j = 0; j < 3; ++j) {
      draw.view.m[3][j] = j == 2 ? 10 : 0;
      for (int i = 0; i < 3; ++i) draw.view.m[3][j] -= draw.world.m[3][i] * draw.view.m[i][j];
    }
    const Plane plane = {0.6, 0, 0.8, -8};
    const double place[] = {0.5, 0.1, -0.3};
    const auto made = PlaneConstantFor(PlaneSpace::kClip, plane, KnownIn::kView, draw);
    const auto followed =
        PredictEdgeError(PlaneSpace::kClip, plane, KnownIn::kView, draw, {place, 1, 0.1}, 1080);
    EXPECT_NEAR(made.value.edge_error / followed.value, 1, 0.2) << away;
  }
}

TEST(PlaneConstantFor, WorldOffsetsCostNothingInDouble) {
  // The object sits at 1e7 and the plane one unit from its origin: a float product of the matrices
  // would lose the unit.
  DrawMatrices draw = {{}, {}, PerspectiveCamera(0.1, 100).projection};
  draw.world.m[3][0] = 1e7;
  draw.view.m[3][0] = -1e7;
  const Plane view = {1, 0, 0, -1};
  const auto object = PlaneConstantFor(PlaneSpace::kObject, view, KnownIn::kView, draw);
  ASSERT_TRUE(object.ok());
  EXPECT_EQ(object.value.plane.constant.w, -1.0f);
  const auto world =
      PlaneConstantFor(PlaneSpace::kObject, {1, 0, 0, -1e7 - 1}, KnownIn::kWorld, draw);
  EXPECT_EQ(world.value.plane.constant.w, -1.0f);
}

TEST(PlaneConstantFor, ZeroPlaneAndErrors) {
  const DrawMatrices draw = {{}, {}, PerspectiveCamera(0.1, 100).projection};
  for (const PlaneSpace space : kSpaces) {
    const auto zero = PlaneConstantFor(space, {}, KnownIn::kWorld, draw);
    ASSERT_TRUE(zero.ok()) << NameOf(space);
    EXPECT_EQ(zero.value.plane.constant.x, 0);
    EXPECT_TRUE(zero.value.warning.ok());
    const auto nan = PlaneConstantFor(space, {0, 0, std::numeric_limits<double>::quiet_NaN(), 1},
                                      KnownIn::kWorld, draw);
    EXPECT_EQ(nan.status.error(), Error::kNotFinite) << NameOf(space);
    DrawMatrices flat = draw;
    flat.view.m[2][2] = 0;
    const auto singular = PlaneConstantFor(space, {0, 0, 1, 1}, KnownIn::kWorld, flat);
    EXPECT_EQ(singular.status.error(),
              space == PlaneSpace::kObject ? Error::kNone : Error::kSingular)
        << NameOf(space);
  }
}

}  // namespace
}  // namespace clipc::runtime
