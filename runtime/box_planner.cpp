// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/box_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "clip-table/vocabulary.h"

namespace clipc::runtime {
namespace {

constexpr float kUnitRoundoff = 0x1p-24f;
constexpr float kErrorFactor = 10 * kUnitRoundoff;
constexpr float kFloatUnderflow = 0x1p-120f;
// The least normal float. Devices may flush smaller numbers to 0.
constexpr float kLeastNormal = 0x1p-126f;
// Sums below this do not overflow, and leave room for the shader's.
constexpr float kLargestSum = 0x1p120f;
constexpr float kLargestBound = kErrorFactor * kLargestSum;
constexpr float kUndecided = std::numeric_limits<float>::quiet_NaN();

constexpr std::size_t kBlock =
    256;  // 24 bytes each: a block stays in the first-level cache for all planes

// The mark of functions that are inlined into a function for AVX2 and into one for the build's own
// target: the same operations, so the same results.
#if defined(__GNUC__) && defined(__x86_64__)
#define CLIPC_HAS_AVX2_CLONE 1
#define CLIPC_BLOCK_FUNCTION inline __attribute__((always_inline))
#else
#define CLIPC_HAS_AVX2_CLONE 0
#define CLIPC_BLOCK_FUNCTION inline
#endif

// kSize boxes, and the facts found out about them.
template <std::size_t kSize>
struct BoxBlock {
  const float* low[3];
  const float* high[3];
  float largest[3][kSize];  // max(|low|, |high|)
  float flushed[kSize];  // what a distance may lose where the plane's coefficients are flushed to 0
  std::uint32_t in_order[kSize];  // 1 where low <= high on every axis: not so if one is NaN
  float coarse_error[kSize];      // at least E of every plane
  std::uint32_t needed[kSize];    // bits of planes
  std::uint32_t culled[kSize];    // 1 or 0
};

CLIPC_BLOCK_FUNCTION float Magnitude(float number) { return number < 0 ? -number : number; }
// The larger of two numbers; of a number and a NaN `b`, the number.
CLIPC_BLOCK_FUNCTION float Larger(float a, float b) { return a < b ? b : a; }

CLIPC_BLOCK_FUNCTION bool IsZero(const Float4& plane) {
  return plane.x == 0 && plane.y == 0 && plane.z == 0 && plane.w == 0;
}

template <std::size_t kSize>
CLIPC_BLOCK_FUNCTION void MeasureBlock(BoxBlock<kSize>& block) {
  for (std::size_t i = 0; i < kSize; ++i) block.in_order[i] = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const float *low = block.low[axis], *high = block.high[axis];
    for (std::size_t i = 0; i < kSize; ++i) {
      block.largest[axis][i] = Larger(Magnitude(low[i]), Magnitude(high[i]));
      block.in_order[i] &= static_cast<std::uint32_t>(low[i] <= high[i]);
    }
  }
  for (std::size_t i = 0; i < kSize; ++i) {
    block.flushed[i] =
        kLeastNormal * (block.largest[0][i] + block.largest[1][i] + block.largest[2][i]);
  }
}

// Sets `error` to E for a plane whose coefficients have the magnitudes `size`: monotonic in each of
// them, roundings included; NaN, to which no distance compares, where sums are too large. `is_zero`
// is for the zero plane alone, which nothing rounds.
template <std::size_t kSize>
CLIPC_BLOCK_FUNCTION void SetError(const BoxBlock<kSize>& block, const Float4& size, bool is_zero,
                                   float (&error)[kSize]) {
  const float x = size.x, y = size.y, z = size.z, w = size.w;
  // Bounds that are flushed to 0 lose this; the coefficients' own loss is in the block.
  const float underflow = is_zero ? 0 : kFloatUnderflow + kLeastNormal * (x + y + z);
  const float share = is_zero ? 0.0f : 1.0f;
  for (std::size_t i = 0; i < kSize; ++i) {
    const float sum =
        x * block.largest[0][i] + y * block.largest[1][i] + z * block.largest[2][i] + w;
    const float bound = kErrorFactor * sum + (underflow + share * block.flushed[i]);
    error[i] = bound < kLargestBound ? bound : kUndecided;
  }
}

template <std::size_t kSize>
CLIPC_BLOCK_FUNCTION void SetCoarseError(BoxBlock<kSize>& block, const Float4* planes,
                                         std::size_t plane_count) {
  Float4 size;
  for (std::size_t i = 0; i < plane_count; ++i) {
    size.x = Larger(size.x, Magnitude(planes[i].x)),
    size.y = Larger(size.y, Magnitude(planes[i].y));
    size.z = Larger(size.z, Magnitude(planes[i].z)),
    size.w = Larger(size.w, Magnitude(planes[i].w));
  }
  SetError(block, size, false, block.coarse_error);
}

// Plans one plane for a block of boxes, with `error` for E. Returns whether a distance is nearer to
// 0 than `error` for some box in order: then another error might give another answer.
template <std::size_t kSize>
CLIPC_BLOCK_FUNCTION bool PlanBlock(BoxBlock<kSize>& block, const Float4& plane, std::uint32_t bit,
                                    const float (&error)[kSize]) {
  const bool up_x = plane.x >= 0, up_y = plane.y >= 0, up_z = plane.z >= 0;
  const float *near_x = up_x ? block.low[0] : block.high[0],
              *far_x = up_x ? block.high[0] : block.low[0];
  const float *near_y = up_y ? block.low[1] : block.high[1],
              *far_y = up_y ? block.high[1] : block.low[1];
  const float *near_z = up_z ? block.low[2] : block.high[2],
              *far_z = up_z ? block.high[2] : block.low[2];
  const float x = plane.x, y = plane.y, z = plane.z, w = plane.w;
  std::uint32_t close = 0;
  for (std::size_t i = 0; i < kSize; ++i) {
    const float nearest = x * near_x[i] + y * near_y[i] + z * near_z[i] + w;
    const float farthest = x * far_x[i] + y * far_y[i] + z * far_z[i] + w;
    // All comparisons are false for NaN, which needs the plane.
    const bool is_in = nearest >= error[i], is_out = farthest < -error[i];
    block.needed[i] |= is_in ? 0 : bit;
    block.culled[i] |= is_out ? 1 : 0;
    close |= static_cast<std::uint32_t>(is_in ^ (nearest >= 0)) |
             static_cast<std::uint32_t>(is_out ^ (farthest < 0));
  }
  return close != 0;
}

// Writes the plans of the first `count` boxes of a block.
template <std::size_t kSize>
CLIPC_BLOCK_FUNCTION void PlanFullBlock(BoxBlock<kSize>& block, const Float4* planes,
                                        std::size_t plane_count, BoxPlan* plans,
                                        std::size_t count) {
  MeasureBlock(block);
  // One error for all planes is less work, and hardly ever too large. Where it may be, the plane is
  // planned once more with its own error.
  SetCoarseError(block, planes, plane_count);
  for (std::size_t i = 0; i < kSize; ++i) block.needed[i] = block.culled[i] = 0;
  bool close = false;
  for (std::size_t i = 0; i < plane_count; ++i)
    close |= PlanBlock(block, planes[i], 1u << i, block.coarse_error);
  if (close) {
    for (std::size_t i = 0; i < kSize; ++i) block.needed[i] = block.culled[i] = 0;
    for (std::size_t i = 0; i < plane_count; ++i) {
      float error[kSize];
      const Float4& p = planes[i];
      SetError(block, {Magnitude(p.x), Magnitude(p.y), Magnitude(p.z), Magnitude(p.w)}, IsZero(p),
               error);
      PlanBlock(block, p, 1u << i, error);
    }
  }
  const std::uint32_t all = (1u << plane_count) - 1;
  BoxPlan narrow[kSize];
  for (std::size_t i = 0; i < kSize; ++i) {
    // Masks instead of branches, which would keep the loop scalar.
    const std::uint32_t is_culled = block.culled[i], in_order = block.in_order[i];
    const std::uint32_t plan = is_culled * kCulled | ((is_culled - 1) & block.needed[i]);
    narrow[i] = static_cast<BoxPlan>(((0 - in_order) & plan) | ((in_order - 1) & all));
  }
  for (std::size_t i = 0; i < count; ++i) plans[i] = narrow[i];
}

using FullBlock = BoxBlock<kBlock>;
using PlanFunction = void (*)(FullBlock&, const Float4*, std::size_t, BoxPlan*, std::size_t);

void PlanForAnyProcessor(FullBlock& block, const Float4* planes, std::size_t plane_count,
                         BoxPlan* plans, std::size_t count) {
  PlanFullBlock(block, planes, plane_count, plans, count);
}

#if CLIPC_HAS_AVX2_CLONE
__attribute__((target("avx2"))) void PlanForAvx2(FullBlock& block, const Float4* planes,
                                                 std::size_t plane_count, BoxPlan* plans,
                                                 std::size_t count) {
  PlanFullBlock(block, planes, plane_count, plans, count);
}
#endif

PlanFunction ChoosePlanFunction() {
#if CLIPC_HAS_AVX2_CLONE
  if (__builtin_cpu_supports("avx2")) return PlanForAvx2;
#endif
  return PlanForAnyProcessor;
}

bool IsBox(const Box& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.low[axis] <= box.high[axis])) return false;
  }
  return true;
}

// Computes |v| |M_0| |M_1| ... for the corner of largest |v|, and the most that numbers flushed to
// 0 may take away. Returns false where float might overflow.
bool LargestPosition(const Box& box, const Matrix* matrices, std::size_t matrix_count,
                     double (&position)[4], double (&flushed)[4]) {
  constexpr auto kLeast = static_cast<double>(kLeastNormal);
  for (int axis = 0; axis < 3; ++axis) {
    position[axis] = std::max(std::fabs(static_cast<double>(box.low[axis])),
                              std::fabs(static_cast<double>(box.high[axis])));
    flushed[axis] = kLeast;
  }
  position[3] = 1, flushed[3] = 0;
  for (std::size_t k = 0; k < matrix_count; ++k) {
    double next[4], next_flushed[4];
    for (int column = 0; column < 4; ++column) {
      next[column] = 0;
      next_flushed[column] = 8 * kLeast;
      for (int row = 0; row < 4; ++row) {
        const double element = std::fabs(matrices[k].m[row][column]);
        next[column] += position[row] * element;
        next_flushed[column] += flushed[row] * element + kLeast * position[row];
      }
      if (!(next[column] < static_cast<double>(kLargestSum))) return false;
    }
    std::copy(next, next + 4, position);
    std::copy(next_flushed, next_flushed + 4, flushed);
  }
  return true;
}

// The plane's part of a plan: 0, its bit, or kCulled.
std::uint32_t PlanTransformed(const Box& box, const Matrix* matrices, std::size_t matrix_count,
                              const double (&largest)[4], const double (&flushed)[4],
                              const Float4& plane, std::uint32_t bit) {
  Plane before = {plane.x, plane.y, plane.z, plane.w};
  const double sum = largest[0] * std::fabs(before.x) + largest[1] * std::fabs(before.y) +
                     largest[2] * std::fabs(before.z) + largest[3] * std::fabs(before.w);
  if (!(sum < static_cast<double>(kLargestSum))) return bit;
  const bool is_zero = before.x == 0 && before.y == 0 && before.z == 0 && before.w == 0;
  const double steps = static_cast<double>(matrix_count + 1);
  double underflow = static_cast<double>(kFloatUnderflow);
  const double sizes[4] = {std::fabs(before.x), std::fabs(before.y), std::fabs(before.z),
                           std::fabs(before.w)};
  for (int i = 0; i < 4; ++i)
    underflow += flushed[i] * sizes[i] + static_cast<double>(kLeastNormal) * largest[i];
  const double error =
      5 * steps * static_cast<double>(kUnitRoundoff) * sum + (is_zero ? 0 : underflow);
  for (std::size_t k = matrix_count; k-- > 0;) before = PlaneBefore(matrices[k], before);
  const double n[3] = {before.x, before.y, before.z};
  double nearest = before.w, farthest = before.w;
  for (int axis = 0; axis < 3; ++axis) {
    const double at_low = n[axis] * static_cast<double>(box.low[axis]),
                 at_high = n[axis] * static_cast<double>(box.high[axis]);
    nearest += std::min(at_low, at_high);
    farthest += std::max(at_low, at_high);
  }
  if (farthest < -error) return kCulled;
  return nearest >= error ? 0 : bit;
}

}  // namespace

BoxPlan PlanBox(const Box& box, const Float4* planes, std::size_t plane_count) noexcept {
  BoxBlock<1> block;
  for (int axis = 0; axis < 3; ++axis) {
    block.low[axis] = &box.low[axis];
    block.high[axis] = &box.high[axis];
  }
  BoxPlan plan;
  PlanFullBlock(block, planes, std::min<std::size_t>(plane_count, kMaxClipPlanes), &plan, 1);
  return plan;
}

void PlanBoxes(const BoxArrays& boxes, const Float4* planes, std::size_t plane_count,
               BoxPlan* plans) noexcept {
  const PlanFunction plan = ChoosePlanFunction();
  plane_count = std::min<std::size_t>(plane_count, kMaxClipPlanes);
  FullBlock block;
  std::size_t first = 0;
  for (; boxes.count - first >= kBlock; first += kBlock) {
    for (int axis = 0; axis < 3; ++axis) {
      block.low[axis] = boxes.low[axis] + first;
      block.high[axis] = boxes.high[axis] + first;
    }
    plan(block, planes, plane_count, plans + first, kBlock);
  }
  const std::size_t rest = boxes.count - first;
  if (rest == 0) return;
  float copies[6][kBlock] = {};
  for (int axis = 0; axis < 3; ++axis) {
    block.low[axis] = std::copy_n(boxes.low[axis] + first, rest, copies[axis]) - rest;
    block.high[axis] = std::copy_n(boxes.high[axis] + first, rest, copies[3 + axis]) - rest;
  }
  plan(block, planes, plane_count, plans + first, rest);
}

BoxPlan PlanTransformedBox(const Box& box, const Matrix* matrices, std::size_t matrix_count,
                           const Float4* planes, std::size_t plane_count) noexcept {
  plane_count = std::min<std::size_t>(plane_count, kMaxClipPlanes);
  const auto all = static_cast<BoxPlan>((1u << plane_count) - 1);
  double largest[4], flushed[4];
  if (!IsBox(box) || !LargestPosition(box, matrices, matrix_count, largest, flushed)) return all;
  std::uint32_t plan = 0;
  for (std::size_t i = 0; i < plane_count; ++i) {
    plan |= PlanTransformed(box, matrices, matrix_count, largest, flushed, planes[i],
                            std::uint32_t{1} << i);
  }
  return (plan & kCulled) != 0 ? kCulled : static_cast<BoxPlan>(plan);
}

}  // namespace clipc::runtime
