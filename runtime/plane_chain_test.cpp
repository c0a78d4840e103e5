// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Constants through several matrices, held against the same in Wide.
#include "runtime/plane_chain.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

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
      // The camera is near the object.
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

// Mutation: a plane that is rounded to double between world and view has lost the distance.
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

// A step from a plane that is off by as much as it may be: each component stays within its bound.
class EachBound {
 public:
  explicit EachBound(std::uint32_t seed) : random_(seed) {}

  double Any() {
    if (random_.Below(4) == 0) return 0;
    return (random_.Below(2) == 0 ? 1 : -1) * random_.Magnitude(1e-6, 1e6);
  }
  double Large() { return random_.Magnitude(1e-3, 1e3); }
  Bounded AnyPlane() {
    Bounded plane;
    for (int i = 0; i < 4; ++i) {
      const double high = Any(), low = random_.Below(2) == 0 ? 0 : high * 0x1p-54 * Signed();
      plane.plane[i] = {high, low};
      plane.error[i] = random_.Below(2) == 0 ? 0 : std::fabs(Any());
      true_.c[i] = static_cast<Wide>(high) + low +
                   static_cast<Wide>(plane.error[i]) * (random_.Below(2) == 0 ? 1 : -1) * 0x1p-53;
    }
    return plane;
  }
  Matrix AnyProjection(bool is_perspective) {
    Matrix m = {{}};
    m.m[0][0] = Large(), m.m[1][1] = Large();
    for (const int j : {0, 1}) m.m[2][j] = Any(), m.m[3][j] = Any();
    m.m[2][2] = is_perspective ? Any() : Large(), m.m[3][2] = is_perspective ? Large() : Any();
    m.m[is_perspective ? 2 : 3][3] = Large();
    return m;
  }
  Matrix AnyMatrix() {
    Matrix m;
    for (auto& row : m.m) {
      for (int j = 0; j < 3; ++j) row[j] = Any();
    }
    return m;
  }
  // Expects each component of `got` within its bound of `exact`, which the true plane becomes.
  void Expect(const Bounded& got, const WidePlane& exact, const char* what) const {
    for (int i = 0; i < 4; ++i) {
      const Wide value = static_cast<Wide>(got.plane[i].high) + got.plane[i].low;
      const Wide size = Magnitude(value) + Magnitude(exact.c[i]);
      EXPECT_LE(static_cast<double>(Magnitude(value - exact.c[i]) - size * 0x1p-108),
                got.error[i] * 0x1p-53 * (1 + 0x1p-20))
          << what << ' ' << i;
    }
  }
  const WidePlane& True() const { return true_; }

 private:
  double Signed() { return random_.Between(-1, 1); }

  Random random_;
  WidePlane true_ = {};
};

// By hand, of planes whose x and y are 0: z is divided by b, or a; and what it takes from w.
TEST(PlaneChain, CountsTheRoundingsOfAProjection) {
  ProjectionShape shape;
  shape.holds = true, shape.px = shape.py = shape.a = shape.b = 1;
  shape.e = 1;
  const Bounded perspective = ThroughShape(Begin({0, 0, 3, 1}).value, shape);
  shape.e = 0, shape.g = 1;
  const Bounded orthographic = ThroughShape(Begin({0, 0, 1, 3}).value, shape);
  for (const Bounded& made : {perspective, orthographic}) {
    EXPECT_EQ(made.plane[2].high, 1);
    EXPECT_EQ(made.plane[3].high, 2);
    EXPECT_EQ(made.error[2], 1 + 2 * 1);                // a quotient, two differences
    EXPECT_EQ(made.error[3], 2 * 2 + 2 * 3 + 1 + 3.0);  // and a product and what it brings
  }
}

TEST(PlaneChain, EachStepBoundsEachComponent) {
  EachBound each(25);
  for (int i = 0; i < 40000; ++i) {
    const Bounded plane = each.AnyPlane();
    for (const bool is_perspective : {true, false}) {
      Matrix projection = each.AnyProjection(is_perspective);
      const ProjectionShape s = ShapeOf(projection);
      WidePlane p = each.True(), xyw1 = p;
      p.c[0] /= s.px, p.c[1] /= s.py;
      xyw1 = p;
      const Wide rest2 = p.c[2] - s.ox * p.c[0] - s.oy * p.c[1],
                 rest3 = p.c[3] - s.tx * p.c[0] - s.ty * p.c[1];
      p.c[2] = is_perspective ? rest3 / s.b : rest2 / s.a;
      p.c[3] = is_perspective ? (rest2 - s.a * p.c[2]) / s.e : (rest3 - s.b * p.c[2]) / s.g;
      each.Expect(ThroughShape(plane, s), p, is_perspective ? "perspective" : "orthographic");
      if (!is_perspective) continue;
      projection.m[3][0] = projection.m[3][1] = 0;
      xyw1.c[2] = rest2 / s.e;
      each.Expect(ToXyw1(plane, projection).value, xyw1, "xyw1");
    }
    const Matrix matrix = each.AnyMatrix();
    if (LooksTransposed(matrix)) continue;
    each.Expect(Before(plane, matrix, "world").value, WideBefore(matrix, each.True()), "before");
  }
}

}  // namespace
}  // namespace clipc::runtime
