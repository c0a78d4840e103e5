// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/box_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/allocation_count.h"
#include "runtime/clip_plane.h"
#include "runtime/test_cameras.h"

namespace clipc::runtime {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Every way in which a shader may add up four products: any order, pairwise, each fused or not.
template <typename Visit>
void ForEachDot4(const float (&a)[4], const float (&b)[4], Visit visit) {
  int order[4] = {0, 1, 2, 3};
  do {
    const auto [i, j, k, l] = order;
    const float p = a[i] * b[i], q = a[j] * b[j], r = a[k] * b[k], s = a[l] * b[l];
    visit(((p + q) + r) + s);
    visit((p + q) + (r + s));
    visit(std::fma(a[l], b[l], std::fma(a[k], b[k], std::fma(a[j], b[j], p))));
    visit(std::fma(a[j], b[j], p) + std::fma(a[l], b[l], r));
  } while (std::next_permutation(order, order + 4));
}

// The extremes of the exact distance over the box. Exact where Wide has 113 bits: products have 48,
// and the numbers of these tests span less than the rest.
std::pair<Wide, Wide> ExactExtremes(const Box& box, const Float4& plane) {
  Wide low = plane.w, high = plane.w;
  const float n[3] = {plane.x, plane.y, plane.z};
  for (int axis = 0; axis < 3; ++axis) {
    const Wide a = static_cast<Wide>(n[axis]) * box.low[axis],
               b = static_cast<Wide>(n[axis]) * box.high[axis];
    low += std::min(a, b);
    high += std::max(a, b);
  }
  return {low, high};
}

float Nudge(float value, int steps) {
  for (; steps > 0; --steps) value = std::nextafter(value, kInfinity);
  for (; steps < 0; ++steps) value = std::nextafter(value, -kInfinity);
  return value;
}

// A box and a plane that touches one of its extreme corners within a few units in the last place.
std::pair<Box, Float4> TouchingBox(Random& random) {
  Box box;
  const double size = random.Magnitude(1e-3, 1e3), extent = size * random.Magnitude(1e-6, 1);
  const Plane normal = random.PlaneAt(0);
  Float4 plane = {static_cast<float>(normal.x), static_cast<float>(normal.y),
                  static_cast<float>(normal.z), 0};
  for (int axis = 0; axis < 3; ++axis) {
    const double centre = random.Between(-size, size), half = random.Between(0, extent);
    box.low[axis] = static_cast<float>(centre - half);
    box.high[axis] = std::max(box.low[axis], static_cast<float>(centre + half));
  }
  const auto [low, high] = ExactExtremes(box, plane);
  plane.w = Nudge(static_cast<float>(-(random.Below(2) == 0 ? low : high)),
                  static_cast<int>(random.Below(101)) - 50);
  return {box, plane};
}

// No vertex at a corner contradicts the plan, however the shader computes its distance.
void ExpectSafe(const Box& box, const Float4& plane, BoxPlan plan) {
  if (plan == 1) return;
  const auto [low, high] = ExactExtremes(box, plane);
  if (plan == 0) {
    EXPECT_TRUE(low >= 0);
  } else {
    EXPECT_TRUE(high < 0);
  }
  for (int corner = 0; corner < 8; ++corner) {
    const float v[4] = {(corner & 1 ? box.high : box.low)[0], (corner & 2 ? box.high : box.low)[1],
                        (corner & 4 ? box.high : box.low)[2], 1};
    bool safe = true;
    ForEachDot4(v, {plane.x, plane.y, plane.z, plane.w},
                [&](float d) { safe = safe && (plan == 0 ? d >= 0 : d < 0); });
    EXPECT_TRUE(safe) << "corner " << corner << " of a box that "
                      << (plan == 0 ? "needs no plane" : "is culled");
  }
}

TEST(PlanBoxTest, IsSafeForBoxesThatTouchAPlane) {
  Random random(1);
  int decided = 0;
  for (int i = 0; i < 40000; ++i) {
    const auto [box, plane] = TouchingBox(random);
    const BoxPlan plan = PlanBox(box, &plane, 1);
    ExpectSafe(box, plane, plan);
    decided += plan != 1;
  }
  EXPECT_GT(decided, 5000) << "the boxes must not all be too close to say";
}

// A device that flushes what is denormal to 0, before and after each operation.
float Flushed(float number) { return std::fabs(number) < 0x1p-126f ? 0.0f : number; }

float FlushedDot4(const float (&v)[4], const Float4& plane) {
  const float n[4] = {plane.x, plane.y, plane.z, plane.w};
  float sum = 0;
  for (int i = 0; i < 4; ++i) sum = Flushed(sum + Flushed(Flushed(v[i]) * Flushed(n[i])));
  return sum;
}

// Planes with coefficients at the end of float's range, and boxes so far away that these decide.
TEST(PlanBoxTest, IsSafeWhereDenormalsAreFlushed) {
  Random random(3);
  int decided = 0, flushed = 0;
  for (int i = 0; i < 100000; ++i) {
    Box box;
    float n[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double sign = random.Below(2) == 0 ? 1 : -1;
      const bool is_tiny = random.Below(3) != 0;
      n[axis] = static_cast<float>(
          sign * (is_tiny ? random.Magnitude(1e-44, 1e-37) : random.Magnitude(1e-31, 1e-20)));
      const double at = random.Between(-1, 1) *
                        (is_tiny ? random.Magnitude(1e6, 1e36) : random.Magnitude(1e-44, 1));
      box.low[axis] = static_cast<float>(at - std::fabs(at) * 1e-3);
      box.high[axis] = std::max(box.low[axis], static_cast<float>(at + std::fabs(at) * 1e-3));
    }
    const Float4 plane = {n[0], n[1], n[2], static_cast<float>(random.Magnitude(1e-44, 1e-25))};
    const BoxPlan plan = PlanBox(box, &plane, 1);
    if (plan == 1) continue;
    ++decided;
    for (int corner = 0; corner < 8; ++corner) {
      const float v[4] = {(corner & 1 ? box.high : box.low)[0],
                          (corner & 2 ? box.high : box.low)[1],
                          (corner & 4 ? box.high : box.low)[2], 1};
      const float d = FlushedDot4(v, plane);
      EXPECT_TRUE(plan == 0 ? d >= 0 : d < 0) << i;
      flushed += d != v[0] * n[0] + v[1] * n[1] + v[2] * n[2] + plane.w;
    }
    const Matrix identity;
    const BoxPlan transformed = PlanTransformedBox(box, &identity, 1, &plane, 1);
    EXPECT_TRUE(transformed == 1 || transformed == plan);
  }
  EXPECT_GT(decided, 5000);
  EXPECT_GT(flushed, 1000) << "flushing must change distances";
}

// Denormal bounds: a device that flushes them sees the whole box at 0, which the plane clips.
TEST(PlanBoxTest, IsSafeWhereBoundsAreFlushed) {
  const Box box = {{9e-40F, -1, -1}, {1e-39F, 1, 1}};
  const Float4 plane = {1e30F, 0, 0, -1e-10F};
  EXPECT_EQ(PlanBox(box, &plane, 1), 1);
}

TEST(PlanBoxTest, HardlyEverNeedsAPlaneInVain) {
  Random random(2);
  int in_vain = 0, decidable = 0;
  for (int i = 0; i < 100000; ++i) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      const double centre = random.Between(-100, 100), half = random.Between(0.2, 2);
      box.low[axis] = static_cast<float>(centre - half);
      box.high[axis] = static_cast<float>(centre + half);
    }
    const Plane p = random.PlaneAt(random.Between(-25, 25));
    const Float4 plane = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
                          static_cast<float>(p.w)};
    const auto [low, high] = ExactExtremes(box, plane);
    const BoxPlan exact = low >= 0 ? 0 : high < 0 ? kCulled : 1;
    const BoxPlan plan = PlanBox(box, &plane, 1);
    EXPECT_TRUE(plan == exact || plan == 1);
    decidable += exact != 1;
    in_vain += plan != exact;
  }
  EXPECT_GT(decidable, 90000);
  EXPECT_LE(in_vain, 10);
}

TEST(PlanBoxTest, SeveralPlanes) {
  const Float4 planes[6] = {{1, 0, 0, 0}, {-1, 0, 0, 10}, {0, 1, 0, 0},
                            {0, 0, 1, 0}, {0, 0, -1, 10}, {0, -1, 0, 10}};
  EXPECT_EQ(PlanBox({{1, 1, 1}, {2, 2, 2}}, planes, 6), 0);
  EXPECT_EQ(PlanBox({{-1, 1, 1}, {2, 2, 2}}, planes, 6), 0b000001);
  EXPECT_EQ(PlanBox({{-1, 1, 9}, {2, 2, 11}}, planes, 6), 0b010001);
  EXPECT_EQ(PlanBox({{-1, 1, 11}, {2, 2, 12}}, planes, 6), kCulled);
  EXPECT_EQ(PlanBox({{-1, 1, 11}, {2, 2, 12}}, planes, 0), 0);
  EXPECT_EQ(PlanBox({{-99, -99, -99}, {99, 99, 99}}, planes, 99), 0b111111)
      << "there are six planes";
}

TEST(PlanBoxTest, TheZeroPlaneIsNeverNeeded) {
  const Float4 zero, negative = {-0.0f, -0.0f, -0.0f, -0.0f};
  EXPECT_EQ(PlanBox({{-1, -1, -1}, {1, 1, 1}}, &zero, 1), 0);
  EXPECT_EQ(PlanBox({{-1, -1, -1}, {1, 1, 1}}, &negative, 1), 0);
  EXPECT_EQ(PlanBox({{-1, -1, -1}, {kInfinity, 1, 1}}, &zero, 1), 1) << "0 * infinity clips";
}

TEST(PlanBoxTest, WhatCannotBeJudgedNeedsThePlane) {
  const Float4 plane = {1, 0, 0, 10};
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (int i = 0; i < 3; ++i) {
      Box box = {{1, 1, 1}, {2, 2, 2}};
      box.low[i] = bad;
      EXPECT_EQ(PlanBox(box, &plane, 1), 1) << bad;
      box = {{1, 1, 1}, {2, 2, 2}};
      box.high[i] = bad;
      EXPECT_EQ(PlanBox(box, &plane, 1), 1) << bad;
    }
    for (int i = 0; i < 4; ++i) {
      Float4 broken = plane;
      (i == 0 ? broken.x : i == 1 ? broken.y : i == 2 ? broken.z : broken.w) = bad;
      EXPECT_EQ(PlanBox({{1, 1, 1}, {2, 2, 2}}, &broken, 1), 1) << bad;
    }
  }
  EXPECT_EQ(PlanBox({{2, 1, 1}, {1, 2, 2}}, &plane, 1), 1) << "bounds out of order";
  const Float4 huge = {1e38f, 0, 0, 1e38f};
  EXPECT_EQ(PlanBox({{1, 1, 1}, {2, 2, 2}}, &huge, 1), 1) << "the shader's sum may overflow";
  const Float4 tiny = {1e-40f, 0, 0, 1e-40f};
  EXPECT_EQ(PlanBox({{1, 1, 1}, {2, 2, 2}}, &tiny, 1), 1)
      << "the shader may flush it to 0, which keeps, or not";
}

TEST(PlanBoxesTest, APlaneThatIsNanDoesNotHideTheErrorOfAnother) {
  const Box box = {{-9, -12, -18}, {-8, -8, -16}};
  const Float4 planes[] = {{-3e38f, -1, 0, 0}, {kNan, 1, 1, 1}, {-1, 0, -1, -7}};
  const BoxArrays boxes = {
      {&box.low[0], &box.low[1], &box.low[2]}, {&box.high[0], &box.high[1], &box.high[2]}, 1};
  BoxPlan plan = 0;
  PlanBoxes(boxes, planes, 3, &plan);
  EXPECT_EQ(plan, 0b011);
  EXPECT_EQ(PlanBox(box, planes, 3), 0b011);
}

class ManyBoxes {
 public:
  ManyBoxes(std::size_t count, std::uint32_t seed) : random_(seed) {
    for (auto& array : arrays_) array.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double centre = random_.Between(-20, 20), half = random_.Between(0, 5);
        arrays_[axis][i] = static_cast<float>(centre - half);
        arrays_[3 + axis][i] = static_cast<float>(centre + half);
      }
      if (random_.Below(20) == 0) arrays_[random_.Below(6)][i] = Odd();
    }
  }
  float Odd() {
    constexpr float kOdd[] = {kNan,  kInfinity, -kInfinity, 0.0f, -0.0f,
                              3e38f, -3e38f,    1e-45f,     1e30f};
    return kOdd[random_.Below(9)];
  }
  std::vector<Float4> Planes(bool odd) {
    std::vector<Float4> planes(6);
    for (Float4& plane : planes) {
      const Plane p = random_.PlaneAt(random_.Between(-10, 10));
      plane = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
               static_cast<float>(p.w)};
      if (!odd) continue;
      switch (random_.Below(6)) {
        case 0: plane.x = Odd(); break;
        case 1: plane.w = Odd(); break;
        case 2: plane = {}; break;
        // Touches box 0, so that it makes a difference which error bound is used.
        case 3:
          plane = {1, 0, 0,
                   Nudge(-arrays_[std::size_t{3} * random_.Below(2)][0],
                         static_cast<int>(random_.Below(40)))};
          break;
        default: break;
      }
    }
    return planes;
  }
  BoxArrays Arrays() const {
    return {{arrays_[0].data(), arrays_[1].data(), arrays_[2].data()},
            {arrays_[3].data(), arrays_[4].data(), arrays_[5].data()},
            arrays_[0].size()};
  }
  Box At(std::size_t i) const {
    return {{arrays_[0][i], arrays_[1][i], arrays_[2][i]},
            {arrays_[3][i], arrays_[4][i], arrays_[5][i]}};
  }

 private:
  Random random_;
  std::vector<float> arrays_[6];
};

TEST(PlanBoxesTest, IsExactlyPlanBoxOfEach) {
  for (std::uint32_t seed = 1; seed < 400; ++seed) {
    const std::size_t count = seed < 4 ? seed - 1 : seed * 7 % 900;
    ManyBoxes boxes(std::max<std::size_t>(count, 1), seed);
    const std::vector<Float4> planes = boxes.Planes(seed % 2 == 0);
    const std::size_t plane_count = seed % 7;
    BoxArrays arrays = boxes.Arrays();
    arrays.count = count;
    std::vector<BoxPlan> plans(count + 1, 0x55);
    PlanBoxes(arrays, planes.data(), plane_count, plans.data());
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(plans[i], PlanBox(boxes.At(i), planes.data(), plane_count))
          << "seed " << seed << " box " << i;
    }
    EXPECT_EQ(plans[count], 0x55);
  }
}

TEST(PlanBoxesTest, DoesNotAllocate) {
  ManyBoxes boxes(1000, 1);
  const std::vector<Float4> planes = boxes.Planes(false);
  std::vector<BoxPlan> plans(1000);
  const std::size_t before = AllocationCount();
  PlanBoxes(boxes.Arrays(), planes.data(), 6, plans.data());
  EXPECT_EQ(AllocationCount(), before);
}

// The float arithmetic of a shader that multiplies by one matrix after the other; `way` chooses
// order and fusing.
void TransformInFloat(const float (&v)[4], const Matrix& matrix, std::uint32_t way,
                      float (&to)[4]) {
  for (int j = 0; j < 4; ++j) {
    float column[4];
    for (int i = 0; i < 4; ++i) column[i] = static_cast<float>(matrix.m[i][j]);
    std::uint32_t number = 0;
    ForEachDot4(v, column, [&](float d) {
      if (number++ == way % 96) to[j] = d;
    });
  }
}

TEST(PlanTransformedBoxTest, IsSafeForPlanesInClipSpace) {
  Random random(3);
  int decided = 0, needed = 0;
  const std::vector<Camera> cameras = AllCameras();
  for (int i = 0; i < 12000; ++i) {
    const Camera& camera = cameras[random.Below(static_cast<std::uint32_t>(cameras.size()))];
    const double depth = random.Magnitude(1, 1000), size = depth * random.Magnitude(1e-3, 0.3);
    Matrix world_view = random.Rigid(0);
    world_view.m[3][2] = camera.forward * depth;
    // The matrices are one or two, rounded to float as the shader gets them.
    std::vector<Matrix> matrices = {world_view, camera.projection};
    if (random.Below(2) == 0) matrices = {Multiply(world_view, camera.projection)};
    for (Matrix& matrix : matrices) {
      for (auto& row : matrix.m) {
        for (double& element : row) element = static_cast<double>(static_cast<float>(element));
      }
    }
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      box.high[axis] = static_cast<float>(random.Between(0.1, 1) * size);
      box.low[axis] = -box.high[axis];
    }
    // A plane that almost touches an extreme corner.
    Plane object = random.PlaneAt(0);
    const double reach = std::fabs(object.x) * static_cast<double>(box.high[0]) +
                         std::fabs(object.y) * static_cast<double>(box.high[1]) +
                         std::fabs(object.z) * static_cast<double>(box.high[2]);
    object.w = (random.Below(2) == 0 ? 1 : -1) * reach +
               random.Between(-1, 1) * size * random.Magnitude(1e-7, 1e-2);
    const Result<PlaneConstant> clip =
        ClipPlaneFromObject(object, world_view, {}, camera.projection);
    ASSERT_TRUE(clip.ok()) << clip.status.message();
    const Float4 plane = clip.value.constant;
    const BoxPlan plan = PlanTransformedBox(box, matrices.data(), matrices.size(), &plane, 1);
    needed += plan == 1;
    if (plan == 1) continue;
    ++decided;
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
      float v[4] = {(corner & 1 ? box.high : box.low)[0], (corner & 2 ? box.high : box.low)[1],
                    (corner & 4 ? box.high : box.low)[2], 1};
      for (const Matrix& matrix : matrices) {
        float next[4];
        TransformInFloat(v, matrix, random.Below(96), next);
        std::copy(next, next + 4, v);
      }
      bool safe = true;
      ForEachDot4(v, {plane.x, plane.y, plane.z, plane.w},
                  [&](float d) { safe = safe && (plan == 0 ? d >= 0 : d < 0); });
      EXPECT_TRUE(safe) << camera.name;
    }
  }
  EXPECT_GT(decided, 1000);
  EXPECT_GT(needed, 100);
}

// A denormal vertex, element or coefficient beside a large number: a device that flushes it to 0
// sees the box on the other side.
TEST(PlanTransformedBoxTest, IsSafeWhereDenormalsAreFlushed) {
  const auto plan = [](float bound, float element, float coefficient, bool is_flushed) {
    const Box box = {{bound, -1, -1}, {1.1F * bound, 1, 1}};
    Matrix matrix;
    matrix.m[0][0] = static_cast<double>(element);
    const Float4 plane = {coefficient, 0, 0, -5e-10F};
    const float v[4] = {bound, 0, 0, 1};
    const float x = FlushedDot4(v, {element, 0, 0, 0}), moved[4] = {x, 0, 0, 1};
    EXPECT_EQ(FlushedDot4(moved, plane) < 0, is_flushed);
    return PlanTransformedBox(box, &matrix, 1, &plane, 1);
  };
  constexpr float kLarge = 1e30F, kDenormal = 1e-39F;
  EXPECT_EQ(plan(kDenormal, kLarge, 1, true), 1);
  EXPECT_EQ(plan(kDenormal, 1, kLarge, true), 1);
  EXPECT_EQ(plan(kLarge, kDenormal, 1, true), 1);
  EXPECT_EQ(plan(1, kDenormal, kLarge, true), 1);
  EXPECT_EQ(plan(kLarge, 1, kDenormal, true), 1);
  EXPECT_EQ(plan(1, kLarge, kDenormal, true), 1);
  EXPECT_EQ(plan(1e-19F, 1e-20F, kLarge, true), 1);  // a product that is denormal
  EXPECT_EQ(plan(1e-30F, 1e21F, 1, false), 0);
}

// Three products that are denormal: flushed, they do not outweigh what the plane takes.
TEST(PlanTransformedBoxTest, IsSafeWhereProductsAreFlushed) {
  const Box box = {{1.1e-10F, 1.1e-10F, 1.1e-10F}, {1.11e-10F, 1.11e-10F, 1.11e-10F}};
  const Float4 plane = {1e-28F, 1e-28F, 1e-28F, -2e-38F};
  const float v[4] = {box.low[0], box.low[1], box.low[2], 1};
  EXPECT_LT(FlushedDot4(v, plane), 0);
  const Matrix identity;
  EXPECT_EQ(PlanTransformedBox(box, &identity, 1, &plane, 1), 1);
}

// E is 5 steps u S: S is 3 here, and one matrix makes two steps.
TEST(PlanTransformedBoxTest, EachMatrixIsAStep) {
  const auto plan = [](float units, std::size_t matrix_count) {
    const Float4 plane = {1, 0, 0, -(1 - units * 0x1p-24F)};
    const Matrix identities[2];
    return PlanTransformedBox({{1, 0, 0}, {2, 0, 0}}, identities, matrix_count, &plane, 1);
  };
  for (const std::size_t matrix_count : {0u, 1u, 2u}) {
    const float limit = 15 * static_cast<float>(matrix_count + 1);
    EXPECT_EQ(plan(limit - 2, matrix_count), 1) << matrix_count;
    EXPECT_EQ(plan(limit + 2, matrix_count), 0) << matrix_count;
  }
}

TEST(PlanTransformedBoxTest, WithoutMatricesIsPlanBoxWithHalfTheError) {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const auto [box, plane] = TouchingBox(random);
    const BoxPlan in_double = PlanTransformedBox(box, nullptr, 0, &plane, 1),
                  in_float = PlanBox(box, &plane, 1);
    EXPECT_TRUE(in_double == in_float || in_float == 1);
    ExpectSafe(box, plane, in_double);
  }
}

TEST(PlanTransformedBoxTest, WhatCannotBeJudgedNeedsThePlane) {
  const Float4 planes[2] = {{1, 0, 0, 10}, {0, 1, 0, 10}};
  const Matrix identity;
  EXPECT_EQ(PlanTransformedBox({{1, 1, 1}, {2, 2, 2}}, &identity, 1, planes, 2), 0);
  EXPECT_EQ(PlanTransformedBox({{1, 1, kNan}, {2, 2, 2}}, &identity, 1, planes, 2), 3);
  EXPECT_EQ(PlanTransformedBox({{1, 1, -kInfinity}, {2, 2, 2}}, &identity, 1, planes, 2), 3);
  Matrix huge, broken;
  huge.m[0][0] = 1e37;
  broken.m[2][2] = static_cast<double>(kNan);
  EXPECT_EQ(PlanTransformedBox({{1, 1, 1}, {2, 2, 2}}, &huge, 1, planes, 2), 3);
  EXPECT_EQ(PlanTransformedBox({{1, 1, 1}, {2, 2, 2}}, &broken, 1, planes, 2), 3);
  EXPECT_EQ(PlanTransformedBox({{2, 1, 1}, {1, 2, 2}}, &identity, 1, planes, 2), 3);
  const Float4 nan = {kNan, 0, 0, 0}, zero, large = {1e38F, 0, 0, 1e38F};
  EXPECT_EQ(PlanTransformedBox({{1, 1, 1}, {2, 2, 2}}, &identity, 1, &large, 1), 1);
  EXPECT_EQ(PlanTransformedBox({{1, 1, 1}, {2, 2, 2}}, &identity, 1, &nan, 1), 1);
  EXPECT_EQ(PlanTransformedBox({{1, 1, 1}, {2, 2, 2}}, &identity, 1, &zero, 1), 0);
}

}  // namespace
}  // namespace clipc::runtime
