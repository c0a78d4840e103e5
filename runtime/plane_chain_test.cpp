// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Constants through several matrices, held against the same in Wide.
#include "runtime/plane_chain.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "runtime/plane_space.h"
#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

struct WidePlane {
  Wide c[4];
};

Wide Magnitude(Wide number) { return number < 0 ? -number : number; }

WidePlane WideBefore(const Matrix& matrix, const WidePlane& plane) {
  WidePlane before = {};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) before.c[i] += static_cast<Wide>(matrix.m[i][j]) * plane.c[j];
  }
  return before;
}

// Gaussian elimination in Wide; the translation, last row and column of an affine matrix, is left
// out until the end.
WidePlane WideAfter(const Matrix& matrix, const WidePlane& plane) {
  Wide a[4][5];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) a[i][j] = matrix.m[i][j];
    a[i][4] = plane.c[i];
  }
  for (int k = 0; k < 4; ++k) {
    int pivot = k;
    const int end = k < 3 ? 3 : 4;
    for (int i = k + 1; i < end; ++i) {
      if (Magnitude(a[i][k]) > Magnitude(a[pivot][k])) pivot = i;
    }
    if (a[pivot][k] == 0) pivot = 3;
    std::swap(a[pivot], a[k]);
    for (int i = 0; i < 4; ++i) {
      if (i == k) continue;
      const Wide factor = a[i][k] / a[k][k];
      for (int j = k; j < 5; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  WidePlane after;
  for (int k = 0; k < 4; ++k) after.c[k] = a[k][4] / a[k][k];
  return after;
}

WidePlane Exactly(PlaneSpace space, const Plane& plane, KnownIn known_in,
                  const DrawMatrices& draw) {
  WidePlane p = {{plane.x, plane.y, plane.z, plane.w}};
  if (space == PlaneSpace::kObject) {
    if (known_in == KnownIn::kView) p = WideBefore(draw.view, p);
    return known_in == KnownIn::kObject ? p : WideBefore(draw.world, p);
  }
  if (known_in == KnownIn::kObject) p = WideAfter(draw.world, p);
  if (known_in != KnownIn::kView) p = WideAfter(draw.view, p);
  if (space == PlaneSpace::kClip) return WideAfter(draw.projection, p);
  const auto& m = draw.projection.m;
  return {{p.c[0] / m[0][0], p.c[1] / m[1][1], p.c[2], p.c[3]}};
}

// The largest difference, relative to the largest component.
double Difference(const Plane& plane, const WidePlane& exact) {
  const double c[4] = {plane.x, plane.y, plane.z, plane.w};
  Wide most = 0, largest = 0;
  for (int i = 0; i < 4; ++i) {
    most = std::max(most, Magnitude(c[i] - exact.c[i]));
    largest = std::max(largest, Magnitude(exact.c[i]));
  }
  return static_cast<double>(most / largest);
}

constexpr PlaneSpace kSpaces[] = {PlaneSpace::kClip, PlaneSpace::kXyw1, PlaneSpace::kObject};
constexpr KnownIn kPlaces[] = {KnownIn::kObject, KnownIn::kWorld, KnownIn::kView};

// From Earth's radius in metres to where a double has two digits left, nothing is lost and nothing
// refused.
TEST(PlaneChain, NoOffsetCostsDigits) {
  Random random(21);
  const Matrix projection = PerspectiveCamera(0.1, 1000).projection;
  for (const double offset : {0.0, 6.4e6, 1e10, 1e13, 1e16}) {
    for (int i = 0; i < 100; ++i) {
      DrawMatrices draw = {random.Rigid(offset), random.Rigid(0), projection};
      // The camera stands near the object.
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) draw.view.m[3][j] -= draw.world.m[3][k] * draw.view.m[k][j];
      }
      const Plane plane = random.PlaneAt(5);
      for (const KnownIn known_in : kPlaces) {
        for (const PlaneSpace space : kSpaces) {
          const auto constant = PlaneConstantFor(space, plane, known_in, draw);
          ASSERT_TRUE(constant.ok()) << offset << ' ' << constant.status.message();
          const PlaneConstant& made = constant.value.plane;
          const double difference = Difference(made.plane, Exactly(space, plane, known_in, draw));
          EXPECT_LE(difference, 2 * made.condition * 0x1p-53)
              << NameOf(space) << ' ' << static_cast<int>(known_in) << ' ' << offset;
          EXPECT_LT(made.condition, 1000);
        }
      }
    }
  }
}

// Mutation: what is rounded to double between world and view has lost the distance.
TEST(PlaneChain, RoundingInBetweenWouldCostThem) {
  Random random(22);
  const double offset = 1e13;
  DrawMatrices draw = {random.Rigid(offset), random.Rigid(0), {}};
  for (int j = 0; j < 3; ++j) {
    for (int k = 0; k < 3; ++k) draw.view.m[3][j] -= draw.world.m[3][k] * draw.view.m[k][j];
  }
  const Plane plane = random.PlaneAt(5);
  const WidePlane exact =
      WideAfter(draw.view, WideAfter(draw.world, {{plane.x, plane.y, plane.z, plane.w}}));
  const Step in_world = Through(Begin(plane), draw.world, "world");
  EXPECT_LT(Difference(Finish(Through(in_world, draw.view, "view")).value.plane, exact), 0x1p-50);
  const Plane rounded = Rounded(in_world.value);
  EXPECT_GT(Difference(Finish(Through(Begin(rounded), draw.view, "view")).value.plane, exact),
            1e-6);
}

// The bound holds for matrices of every kind, or the plane is refused.
TEST(PlaneChain, ConditionBoundsTheError) {
  Random random(23);
  int kept = 0, refused = 0;
  for (int i = 0; i < 5000; ++i) {
    const Matrix matrix = random.NearlySingular(2, random.Magnitude(1e-17, 1e-10));
    const Plane plane = random.PlaneAt(random.Between(-9, 9));
    const auto after = Finish(Through(Begin(plane), matrix, "view"));
    if (!after.ok()) {
      ++refused;
      continue;
    }
    ++kept;
    const WidePlane exact = WideAfter(matrix, {{plane.x, plane.y, plane.z, plane.w}});
    EXPECT_LE(Difference(after.value.plane, exact), 4 * after.value.condition * 0x1p-53);
  }
  EXPECT_GT(kept, 1000);
  EXPECT_GT(refused, 500);
}

// The second of two matrices enlarges what the first loses, so the condition counts both.
TEST(PlaneChain, ConditionCountsEveryMatrix) {
  Random random(24);
  int kept = 0;
  for (int i = 0; i < 2000; ++i) {
    const double size = random.Magnitude(1e-11, 1e-8);
    const Matrix first = random.NearlySingular(2, size), second = random.NearlySingular(2, size);
    const Plane plane = random.PlaneAt(random.Between(-9, 9));
    const auto after = Finish(Through(Through(Begin(plane), first, "world"), second, "view"));
    if (!after.ok()) continue;
    ++kept;
    const WidePlane exact =
        WideAfter(second, WideAfter(first, {{plane.x, plane.y, plane.z, plane.w}}));
    EXPECT_LE(Difference(after.value.plane, exact), 4 * after.value.condition * 0x1p-53);
  }
  EXPECT_GT(kept, 100);
}

}  // namespace
}  // namespace clipc::runtime
