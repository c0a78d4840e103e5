// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Single roundings of a shader whose numbers show which one it is; study/regimes_test.cpp
// holds all of them together against what is measured.
#include "runtime/edge_error.h"

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/plane_space.h"
#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

// `normal` is the plane's in object space, which has the directions of view space.
double ErrorOf(const DistanceArithmetic& arithmetic, const double (&normal)[3],
               const std::vector<double>& places) {
  Matrix world_view;
  for (int j = 0; j < 3; ++j) world_view.m[3][j] = (j == 2 ? 10 : 0) - places[j];
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  const SeenDraw draw = {{normal[0] / length, normal[1] / length, normal[2] / length, 0},
                         world_view,
                         PerspectiveCamera(0.1, 100).projection,
                         {}};
  return EdgeErrorOf(arithmetic, draw, {places.data(), places.size() / 3, 0.1}, 1080, kAnySurface)
      .along_surface;
}

// The shader dots one coordinate of v * matrix.
DistanceArithmetic CoordinateOf(const Matrix& matrix, int coordinate) {
  DistanceArithmetic arithmetic;
  arithmetic.matrices[0] = matrix, arithmetic.count = 1;
  double* const c[] = {&arithmetic.constant.x, &arithmetic.constant.y, &arithmetic.constant.z,
                       &arithmetic.constant.w};
  *c[coordinate] = 1;
  return arithmetic;
}

constexpr double kNormal[3] = {0.3, 0.4, 0.7};
Matrix WithColumns(std::initializer_list<int> columns) {
  Matrix matrix = {{}};
  for (const int j : columns) {
    for (int i = 0; i < 3; ++i) matrix.m[i][j] = kNormal[i];
    matrix.m[3][j] = 10;
  }
  return matrix;
}

const std::vector<double> kPlace = {31, -17, 23};

TEST(EdgeError, EachColumnRoundsAsEachOther) {
  const double error = ErrorOf(CoordinateOf(WithColumns({0}), 0), kNormal, kPlace);
  EXPECT_GT(error, 1e-5);
  for (const int j : {1, 2, 3})
    EXPECT_DOUBLE_EQ(ErrorOf(CoordinateOf(WithColumns({j}), j), kNormal, kPlace), error) << j;
  // z and w of the same numbers have one error.
  EXPECT_DOUBLE_EQ(ErrorOf(CoordinateOf(WithColumns({2, 3}), 2), kNormal, kPlace), error);
}

// One matrix is multiplied by the vertex, however it was made.
TEST(EdgeError, AProductWithTheIdentityRoundsNothingMore) {
  DistanceArithmetic arithmetic = CoordinateOf(WithColumns({0}), 0);
  const double error = ErrorOf(arithmetic, kNormal, kPlace);
  arithmetic.count = 2;
  EXPECT_DOUBLE_EQ(ErrorOf(arithmetic, kNormal, kPlace), error);
  for (const auto product : {FloatProduct::kFromLeft, FloatProduct::kFromRight}) {
    arithmetic.product = product;
    EXPECT_DOUBLE_EQ(ErrorOf(arithmetic, kNormal, kPlace), error);
  }
}

TEST(EdgeError, PowersOfTwoAreExact) {
  for (const int j : {0, 1, 2}) {
    const auto error = [&](double element) {
      Matrix matrix;
      matrix.m[j][j] = element;
      double normal[3] = {};
      normal[j] = 1;
      return ErrorOf(CoordinateOf(matrix, j), normal, kPlace);
    };
    EXPECT_EQ(error(0.125), 0) << j;
    EXPECT_GT(error(0.1), 0) << j;
  }
}

// A coefficient below float's least normal number is off by half of float's least number, however
// small it is.
TEST(EdgeError, DenormalCoefficientsHaveOneUnit) {
  DistanceArithmetic arithmetic;
  const auto error = [&](double coefficient) {
    arithmetic.constant = {0x1p-99, coefficient, 0, 0};
    return ErrorOf(arithmetic, {1, 0, 0}, {0, 1e12, 0});
  };
  EXPECT_GT(error(3e-41), 0.01);
  EXPECT_NEAR(error(3e-41) / error(3e-42), 1, 1e-3);
}

// Places of the cut: as many as there are up to 64, four times as many with a fourth of the edges
// each.
TEST(EdgeError, PlacesAreSpreadOverTheCut) {
  const DistanceArithmetic arithmetic = CoordinateOf(WithColumns({0}), 0);
  const auto error = [&](std::size_t count, auto is_near) {
    std::vector<double> places;
    for (std::size_t i = 0; i < count; ++i) {
      places.insert(places.end(), kPlace.begin(), kPlace.end());
      // Seen from nearer, an error is larger.
      if (is_near(i)) places[3 * i + 2] -= 9;
    }
    return ErrorOf(arithmetic, kNormal, places);
  };
  const auto none = [](std::size_t) { return false; };
  const double one = error(1, none), many = error(64, none);
  EXPECT_NEAR(many / one, 1, 0.05);
  EXPECT_GT(std::fabs(many / one - 1), 1e-6);  // each place has directions of its own
  EXPECT_NEAR(error(256, none) / many, 1, 0.02);
  EXPECT_GT(error(256, [](std::size_t i) { return i % 4 == 1; }), 3 * many);
  EXPECT_GT(error(512, [](std::size_t i) { return i >= 256; }), 3 * many);
}

// An edge along the line of sight is seen as one place, wherever on it the plane cuts: what moves a
// cut in depth moves it in the image too. Without that the prediction for single draws of
// study/regimes.h would be a quarter of what it is.
TEST(EdgeError, CountsWhatIsSeenOfAMoveInDepth) {
  for (const double off : {0.0, 2.0}) {
    DrawMatrices draw = {{}, {}, PerspectiveCamera(0.1, 1000, {}, 1, off, 0, 100).projection};
    draw.world.m[3][2] = 10;
    const double place[] = {7, 5, -1};
    const auto error = [&](const Plane& view_plane) {
      return PredictEdgeError(PlaneSpace::kXyw1, view_plane, KnownIn::kView, draw, {place, 1, 0.1},
                              1080, 1)
          .value;
    };
    // The edge has the direction of the plane's normal.
    const double along = error({7, 5, 9, -(7 * 7 + 5 * 5 + 9 * 9)});
    const double across = error({9, 0, -7, 0}), in_depth = error({0, 0, 1, -9});
    EXPECT_LT(along, 1e-9 * across) << off;
    EXPECT_GT(in_depth, 0.1 * across) << off;
  }
  // A frustum that is shifted as a whole: its eye is one to the left.
  DrawMatrices draw = {{}, {}, PerspectiveCamera(0.1, 1000).projection};
  draw.world.m[3][2] = 10, draw.projection.m[3][0] = draw.projection.m[0][0];
  const double place[] = {7, 5, -1};
  const auto error = [&](const Plane& plane) {
    return PredictEdgeError(PlaneSpace::kClip, plane, KnownIn::kView, draw, {place, 1, 0.1}, 1080,
                            1)
        .value;
  };
  EXPECT_LT(error({8, 5, 9, -(8 * 7 + 5 * 5 + 9 * 9)}), 1e-9 * error({9, 0, -7, 0}));
}

}  // namespace
}  // namespace clipc::runtime
