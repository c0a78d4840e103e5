// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "runtime/plane_space.h"
#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

TEST(PredictEdgeError, GrowsWithTheDistanceOverNear) {
  const auto error = [](const Camera& camera, double distance) {
    return PredictEdgeError(PlaneSpace::kClip, {0, 0, 1, -distance}, camera.projection, 1080).value;
  };
  // 0.0012 px * |Cw|/n at 60 degrees and 1080 rows.
  const Camera standard = PerspectiveCamera(0.1, 1e6);
  EXPECT_NEAR(error(standard, 30), 0.0012 * 300, 0.015);
  EXPECT_NEAR(error(standard, 60) / error(standard, 30), 2, 0.01);
  EXPECT_NEAR(error(PerspectiveCamera(0.01, 1e6), 30) / error(standard, 30), 10, 0.1);
  const double floor =
      PredictEdgeError(PlaneSpace::kXyw1, {0, 0, 1, -30}, standard.projection, 1080).value;
  EXPECT_NEAR(error(PerspectiveCamera(0.1, 1e6, {false, true}), 30), floor, 1e-4 * floor);
  EXPECT_EQ(error(PerspectiveCamera(0.1, INFINITY, {false, true}), 30), floor);
  // The plane's length does not count.
  EXPECT_NEAR(PredictEdgeError(PlaneSpace::kClip, {0, 0, 5, -150}, standard.projection, 1080).value,
              error(standard, 30), 1e-12);
  const auto xyw1 = [&](const Plane& plane) {
    return PredictEdgeError(PlaneSpace::kXyw1, plane, standard.projection, 1080).value;
  };
  for (const double length : {0x1p-1074, 0x1.8p1023})
    EXPECT_NEAR(xyw1({length, length, length, 0}) / xyw1({1, 1, 1, 0}), 1, 1e-12) << length;
  EXPECT_EQ(
      PredictEdgeError(PlaneSpace::kClip, {0, 0, 0, 1}, standard.projection, 1080).status.error(),
      Error::kSingular);
  Matrix general;
  general.m[0][1] = 1;
  EXPECT_EQ(PredictEdgeError(PlaneSpace::kClip, {0, 0, 1, 1}, general, 1080).status.error(),
            Error::kWrongProjection);
}

// The laws of the header's table, in units of 2^-24 H/2 / sine.
double LawOf(PlaneSpace space, const Plane& plane, const Matrix& projection,
             double reach = kAroundOrigin) {
  return PredictEdgeError(space, plane, projection, 1080, 0.5, reach).value / (0x1p-24 * 540 / 0.5);
}

TEST(PredictEdgeError, GrowsAsTheViewNarrowsAndOffTheAxis) {
  const Plane facing = {0, 0, -1, 30}, tilted = {0, 0.6, -0.8, 30};
  const auto at = [](double fov, double off) {
    return PerspectiveCamera(0.1, 100, {}, 1, off, 0, fov).projection;
  };
  for (const double fov : {1.0, 60.0}) {
    const double py = at(fov, 0).m[1][1];
    EXPECT_NEAR(LawOf(PlaneSpace::kXyw1, facing, at(fov, 0)), 2 + py, 1e-9);
    EXPECT_NEAR(LawOf(PlaneSpace::kXyw1, tilted, at(fov, 0)), 2 + 0.8 * py, 1e-9);
    EXPECT_NEAR(LawOf(PlaneSpace::kObject, tilted, at(fov, 0)), 0.75, 1e-9);
  }
  EXPECT_NEAR(LawOf(PlaneSpace::kXyw1, facing, at(60, 3)), 2 + 6 + at(60, 0).m[1][1], 1e-9);
  // A plane that leans to the side of the tile has more of w in its constant.
  const Plane sideways = {0.6, 0, 0.8, -30};
  const Matrix tile = at(60, -3);
  EXPECT_NEAR(LawOf(PlaneSpace::kXyw1, sideways, tile),
              2 + 6 + (0.8 + 3 * 0.6 / tile.m[0][0]) * tile.m[1][1], 1e-9);
  Matrix above = PerspectiveCamera(0.1, 100, {}, 1, 0, -3).projection;
  EXPECT_NEAR(LawOf(PlaneSpace::kXyw1, {0, 0.6, 0.8, -30}, above),
              2 + 6 + 0.8 * above.m[1][1] + 3 * 0.6, 1e-9);
  above.m[1][1] *= -1, above.m[2][1] *= -1;  // y down
  EXPECT_NEAR(LawOf(PlaneSpace::kXyw1, {0, 0.6, 0.8, -30}, above),
              2 + 6 + std::fabs(0.8 * above.m[1][1] + 3 * 0.6 * -1), 1e-9);
}

TEST(PredictEdgeError, GrowsWithTheDistanceOfAnOrthographicEye) {
  const Plane tilted = {0, 0.6, -0.8, 30};
  const auto law = [&](bool reversed, PlaneSpace space) {
    return LawOf(space, tilted, OrthographicCamera(0.1, 100, {false, reversed}).projection);
  };
  // The error grows with the distance of the eye from the plane. With reversed depth, z is near 1
  // for everything that is near, so the error grows with the distance of the far plane, too.
  EXPECT_NEAR(law(false, PlaneSpace::kClip), 2 + 0.1 * 30, 1e-9);
  EXPECT_NEAR(law(true, PlaneSpace::kClip), 2 + 0.1 * 0.8 * 100, 1e-9);
  EXPECT_NEAR(law(true, PlaneSpace::kObject), 0.75, 1e-9);
  Matrix tile = OrthographicCamera(0.1, 100).projection;
  tile.m[3][0] = 3;
  EXPECT_NEAR(LawOf(PlaneSpace::kClip, tilted, tile), 2 + 6 + 0.1 * 30, 1e-9);
  tile.m[3][1] = 4;
  EXPECT_NEAR(LawOf(PlaneSpace::kClip, tilted, tile), 2 + 10 + 0.1 * 30, 1e-9);
  EXPECT_EQ(
      PredictEdgeError(PlaneSpace::kXyw1, tilted, OrthographicCamera(0.1, 100).projection, 1080)
          .status.error(),
      Error::kWrongProjection);
}

TEST(PredictEdgeError, GrowsWithTheReachOfTheVertices) {
  const Matrix projection = PerspectiveCamera(0.1, 1e6).projection;
  const Plane plane = {0, 0, 1, -30};
  const double py = projection.m[1][1];
  const auto law = [&](PlaneSpace space, double reach) {
    return LawOf(space, plane, projection, reach);
  };
  EXPECT_NEAR(law(PlaneSpace::kXyw1, 1000), 1 + py + 2000, 1e-6);
  EXPECT_NEAR(law(PlaneSpace::kClip, 1000) / (1 + py + 2000 + 1.4 * 300 * (py + 2000)), 1, 1e-6);
  EXPECT_NEAR(law(PlaneSpace::kObject, 1000), 1500, 1e-6);
  EXPECT_NEAR(law(PlaneSpace::kObject, 0), 0.15, 1e-9);
}

// The prediction for a draw whose cut is known; study/regimes_test.cpp measures it.
TEST(PredictEdgeError, FollowsTheRoundingsOfADraw) {
  DrawMatrices draw = {{}, {}, PerspectiveCamera(0.1, 1000).projection};
  draw.world.m[3][2] = 10;
  const double places[] = {0.5, 0.1, -0.375, -0.5, 0.2, 0.375};
  const Plane plane = {0.6, 0, 0.8, -8};
  const auto error = [&](PlaneSpace space, const SeenCut& cut) {
    return PredictEdgeError(space, plane, KnownIn::kWorld, draw, cut, 1080);
  };
  const SeenCut cut = {places, 2, 0.1};
  // The prediction agrees with the law for an object around its own origin.
  EXPECT_NEAR(error(PlaneSpace::kXyw1, cut).value, 0.001, 0.0007);
  EXPECT_NEAR(error(PlaneSpace::kClip, cut).value, 0.1, 0.07);
  EXPECT_LT(error(PlaneSpace::kObject, cut).value, 0.0005);
  EXPECT_GT(error(PlaneSpace::kObject, cut).value, 0);
  // Edges that are much longer than the image lose in proportion to their length.
  const double hundred = error(PlaneSpace::kXyw1, {places, 2, 100}).value;
  EXPECT_GT(hundred, 5 * error(PlaneSpace::kXyw1, cut).value);
  EXPECT_NEAR(error(PlaneSpace::kXyw1, {places, 2, 200}).value / hundred, 2, 0.3);
  // A plane whose normal is an axis, through the object's origin: each vertex's one coordinate is
  // its distance.
  const auto axis = PredictEdgeError(PlaneSpace::kObject, {1, 0, 0, 0}, KnownIn::kObject, draw,
                                     {places + 3, 1, 1e-6}, 1080);
  EXPECT_TRUE(axis.ok());
  EXPECT_EQ(axis.value, 0);
  // The plane's length does not count.
  EXPECT_NEAR(
      PredictEdgeError(PlaneSpace::kXyw1, {2.4, 0, 3.2, -32}, KnownIn::kWorld, draw, cut, 1080)
              .value /
          error(PlaneSpace::kXyw1, cut).value,
      1, 1e-9);
  const double behind[] = {0, 0, -20};
  EXPECT_EQ(error(PlaneSpace::kClip, {behind, 1, 0.1}).status.error(), Error::kInvalidArgument);
  EXPECT_EQ(error(PlaneSpace::kClip, {places, 0, 0.1}).status.error(), Error::kInvalidArgument);
  EXPECT_EQ(error(PlaneSpace::kClip, {places, 2, 0}).status.error(), Error::kInvalidArgument);
  EXPECT_EQ(error(PlaneSpace::kClip, {places, 2, -1}).status.error(), Error::kInvalidArgument);
  const auto object_error = [&](double length, double height) {
    return PredictEdgeError(PlaneSpace::kObject, {0.6 * length, 0, 0.8 * length, -8 * length},
                            KnownIn::kWorld, draw, cut, height)
        .status.error();
  };
  EXPECT_EQ(object_error(1, 1080), Error::kNone);
  EXPECT_EQ(object_error(1e-35, 1080), Error::kNotRepresentable);
  EXPECT_EQ(object_error(1, -1080), Error::kNotFinite);
  draw.view.m[3][2] = NAN;
  EXPECT_EQ(object_error(1, 1080), Error::kNotFinite);
  draw.view = {};
  const double near = error(PlaneSpace::kXyw1, cut).value;
  draw.world.m[3][0] = 1e5, draw.view.m[3][0] = -1e5;
  const auto far_away = [&](MatrixOrder order) {
    draw.order = order;
    return PredictEdgeError(PlaneSpace::kXyw1, {0.6, 0, 0.8, -8 - 6e4}, KnownIn::kWorld, draw, cut,
                            1080)
        .value;
  };
  for (const auto order : {MatrixOrder::kOneMatrix, MatrixOrder::kWorldViewFirst})
    EXPECT_NEAR(far_away(order) / near, 1, 0.3) << static_cast<int>(order);
  for (const auto order : {MatrixOrder::kWorldFirst, MatrixOrder::kThreeMatrices,
                           MatrixOrder::kFloatWorldView, MatrixOrder::kFloatViewProjection})
    EXPECT_GT(far_away(order), 100 * near) << static_cast<int>(order);
  draw.projection.m[3][2] = NAN;
  EXPECT_EQ(error(PlaneSpace::kClip, cut).status.error(), Error::kNotFinite);
}

TEST(PredictEdgeError, RefusesWhatIsNoNumber) {
  const Matrix projection = PerspectiveCamera(0.1, 100).projection;
  const auto of = [&](const Plane& plane, double height, double sine, double reach) {
    return PredictEdgeError(PlaneSpace::kXyw1, plane, projection, height, sine, reach)
        .status.error();
  };
  for (int i = 0; i < 4; ++i) {
    for (const double bad : {static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
      Plane plane = {0.6, 0, 0.8, -1};
      *std::array{&plane.x, &plane.y, &plane.z, &plane.w}[static_cast<std::size_t>(i)] = bad;
      EXPECT_EQ(of(plane, 1080, 1, 0), Error::kNotFinite) << i << ' ' << bad;
    }
  }
  const auto error = [&](double height, double sine, double reach) {
    return of({0, 0, 1, -1}, height, sine, reach);
  };
  EXPECT_EQ(error(-1080, 1, 0), Error::kNotFinite);
  EXPECT_EQ(error(INFINITY, 1, 0), Error::kNotFinite);
  EXPECT_EQ(error(1080, 0, 0), Error::kNotFinite);
  EXPECT_EQ(error(1080, -1, 0), Error::kNotFinite);
  EXPECT_EQ(error(1080, INFINITY, 0), Error::kNotFinite);
  EXPECT_EQ(error(1e200, 1e-110, 1e10), Error::kNotFinite);
  EXPECT_EQ(error(1080, 1, -1), Error::kNotFinite);
  EXPECT_EQ(error(1080, 1, NAN), Error::kNotFinite);
  EXPECT_EQ(error(1080, 1, INFINITY), Error::kNotFinite);
  EXPECT_TRUE(PredictEdgeError(PlaneSpace::kXyw1, {0, 0, 1, -1}, projection, 1080).ok());
}

// Far from the world's origin a rounded world-space vertex takes its cut with it: the surface is
// displaced, and the cut keeps its place on it.
TEST(PredictEdgeError, TellsTheSurfaceFromTheImage) {
  DrawMatrices draw = {{}, {}, PerspectiveCamera(0.1, 1000).projection};
  const double offset[3] = {8000, -5000, 3300}, place[] = {0.3, -0.2, 0.1};
  for (int i = 0; i < 3; ++i) {
    draw.world.m[3][i] = offset[i] + (i == 2 ? 10 : 0);
    draw.view.m[3][i] = -offset[i];
  }
  const Plane cut = {0.4, 0.5, 0.77, -7.7};
  const auto error = [&](PlaneSpace space, MatrixOrder order) {
    draw.order = order;
    const auto all =
        PredictEdgeDisplacement(space, cut, KnownIn::kView, draw, {place, 1, 0.1}, 1080);
    EXPECT_TRUE(all.ok());
    EXPECT_EQ(all.value.along_surface,
              PredictEdgeError(space, cut, KnownIn::kView, draw, {place, 1, 0.1}, 1080).value);
    EXPECT_EQ(all.value.In(JudgedIn::kSurface), all.value.along_surface);
    EXPECT_EQ(all.value.In(JudgedIn::kImage), all.value.in_image);
    EXPECT_GE(all.value.in_image, all.value.along_surface);
    return all.value;
  };
  const EdgeDisplacement one = error(PlaneSpace::kObject, MatrixOrder::kOneMatrix);
  EXPECT_LT(one.in_image, 0.001);
  for (const MatrixOrder order : {MatrixOrder::kWorldFirst, MatrixOrder::kThreeMatrices}) {
    const EdgeDisplacement object = error(PlaneSpace::kObject, order),
                           xyw1 = error(PlaneSpace::kXyw1, order);
    EXPECT_EQ(object.along_surface, one.along_surface);
    EXPECT_GT(object.of_vertices, 0.05);
    EXPECT_EQ(object.of_vertices, xyw1.of_vertices);
    EXPECT_NEAR(object.in_image / object.of_vertices, 1, 0.01);
    EXPECT_GT(xyw1.in_image, 2 * object.in_image);
  }
  // An application that judges by the surface is not warned of its vertices.
  for (int i = 0; i < 3; ++i) draw.world.m[3][i] *= 100, draw.view.m[3][i] *= 100;
  draw.world.m[3][2] = -draw.view.m[3][2] + 10, draw.order = MatrixOrder::kWorldFirst;
  const auto constant = [&](JudgedIn judged_in) {
    return PlaneConstantFor(PlaneSpace::kObject, cut, KnownIn::kView, draw, {1080, 0.5, judged_in})
        .value;
  };
  const SpaceConstant seen = constant(JudgedIn::kImage);
  EXPECT_LT(seen.edge_error, 0.001);
  EXPECT_GT(seen.vertex_error, 5);
  EXPECT_EQ(seen.warning.error(), Error::kIllConditioned);
  EXPECT_NE(std::string(seen.warning.message()).find("multiply its matrices in double"),
            std::string::npos);
  EXPECT_TRUE(constant(JudgedIn::kSurface).warning.ok());
}

TEST(PredictEdgeError, NamesWhatIsWrongWithAProjection) {
  Matrix projection = PerspectiveCamera(0.1, 100).projection;
  const Matrix transposed = Transpose(projection);
  projection.m[1][1] = NAN;
  for (const PlaneSpace space : {PlaneSpace::kClip, PlaneSpace::kXyw1, PlaneSpace::kObject}) {
    EXPECT_EQ(PredictEdgeError(space, {0, 0, 1, -1}, projection, 1080).status.error(),
              Error::kNotFinite);
    EXPECT_EQ(PredictEdgeError(space, {0, 0, 1, -1}, transposed, 1080).status.error(),
              Error::kLooksTransposed);
  }
}

}  // namespace
}  // namespace clipc::runtime
