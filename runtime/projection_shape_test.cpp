// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/projection_shape.h"

#include <cmath>

#include <gtest/gtest.h>

#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

Matrix With(Matrix matrix, int row, int column, double element) {
  matrix.m[row][column] = element;
  return matrix;
}

TEST(ShapeOf, HoldsForWhatTheHeaderShows) {
  const Matrix perspective = PerspectiveCamera(0.1, 100).projection,
               orthographic = OrthographicCamera(0.1, 100).projection;
  for (const Matrix& each : {perspective, orthographic}) {
    EXPECT_TRUE(ShapeOf(each).holds);
    for (int i = 0; i < 16; ++i) EXPECT_FALSE(ShapeOf(With(each, i / 4, i % 4, NAN)).holds) << i;
    for (const int i : {0, 1}) {
      EXPECT_FALSE(ShapeOf(With(each, i, i, 0)).holds);
      for (int j = 0; j < 4; ++j) EXPECT_EQ(ShapeOf(With(each, i, j, 0.5)).holds, i == j);
    }
  }
  EXPECT_FALSE(ShapeOf(With(perspective, 3, 3, 1)).holds);
  EXPECT_FALSE(ShapeOf(With(perspective, 2, 3, 0)).holds);
}

// Every element that is said to be 0 or 1 counts, and each of the others is enough.
TEST(LooksTransposed, IsAnAffineMatrixForColumnVectors) {
  EXPECT_FALSE(LooksTransposed({}));
  for (int i = 0; i < 3; ++i) {
    const Matrix transposed = With({}, i, 3, 5);
    EXPECT_TRUE(LooksTransposed(transposed)) << i;
    for (int j = 0; j < 4; ++j) EXPECT_FALSE(LooksTransposed(With(transposed, 3, j, 0.5))) << j;
  }
}

TEST(CheckProjection, NamesOnlyWhatIsNoProjection) {
  const auto error = [](const Matrix& matrix) { return CheckProjection(matrix).error(); };
  for (const double forward : {1, -1}) {
    const Matrix projection = PerspectiveCamera(0.1, 100, {}, forward).projection;
    const Matrix transposed = Transpose(projection);
    EXPECT_EQ(error(projection), Error::kNone);
    EXPECT_EQ(error(transposed), Error::kLooksTransposed);
    EXPECT_EQ(error(With(projection, 3, 2, 1)), Error::kNone);  // its own last column says w = z
    EXPECT_EQ(error(With(projection, 3, 2, -1)), Error::kNone);
    for (const int j : {0, 1, 3}) EXPECT_EQ(error(With(transposed, 3, j, 0.5)), Error::kNone) << j;
    EXPECT_EQ(error(With(transposed, 3, 2, 0.5)), Error::kNone);
    for (int i = 0; i < 16; ++i)
      EXPECT_EQ(error(With(projection, i / 4, i % 4, INFINITY)), Error::kNotFinite);
  }
  EXPECT_EQ(error(Transpose(OrthographicCamera(0.1, 100).projection)), Error::kLooksTransposed);
}

}  // namespace
}  // namespace clipc::runtime
