// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/box_planner.h"

#include <algorithm>
#include <cmath>
#include <cstring>

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

// The mark of functions that are inlined into a function for AVX2 and into one for the build's own
// target: the same operations, so the same results. GCC for Windows does not align the stack for
// AVX's vectors (GCC bug 54412).
#if defined(__GNUC__) && defined(__x86_64__) && (!defined(_WIN32) || defined(__clang__))
#define CLIPC_HAS_AVX2_CLONE 1
#else
#define CLIPC_HAS_AVX2_CLONE 0
#endif
#if defined(__GNUC__)
#define CLIPC_BLOCK_FUNCTION inline __attribute__((always_inline))
#else
#define CLIPC_BLOCK_FUNCTION inline
#endif

// One number, and the answer of a comparison: all bits, or none.
struct Mask {
  std::uint32_t bits;
};
struct Number {
  float value;
};
CLIPC_BLOCK_FUNCTION Mask operator~(Mask a) { return {~a.bits}; }
CLIPC_BLOCK_FUNCTION Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
CLIPC_BLOCK_FUNCTION Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
CLIPC_BLOCK_FUNCTION Mask operator^(Mask a, Mask b) { return {a.bits ^ b.bits}; }
CLIPC_BLOCK_FUNCTION Mask operator&(Mask a, std::uint32_t b) { return {a.bits & b}; }
CLIPC_BLOCK_FUNCTION Mask operator|(Mask a, std::uint32_t b) { return {a.bits | b}; }
CLIPC_BLOCK_FUNCTION Mask operator-(Mask a, std::uint32_t b) { return {a.bits - b}; }
CLIPC_BLOCK_FUNCTION Mask operator>>(Mask a, int by) { return {a.bits >> by}; }
CLIPC_BLOCK_FUNCTION Number operator-(Number a) { return {-a.value}; }
CLIPC_BLOCK_FUNCTION Number operator+(Number a, Number b) { return {a.value + b.value}; }
CLIPC_BLOCK_FUNCTION Number operator+(Number a, float b) { return {a.value + b}; }
CLIPC_BLOCK_FUNCTION Number operator*(float a, Number b) { return {a * b.value}; }
CLIPC_BLOCK_FUNCTION Mask operator<(Number a, Number b) { return {a.value < b.value ? ~0u : 0}; }
CLIPC_BLOCK_FUNCTION Mask operator<(Number a, float b) { return {a.value < b ? ~0u : 0}; }
CLIPC_BLOCK_FUNCTION Mask operator<=(Number a, Number b) { return {a.value <= b.value ? ~0u : 0}; }
CLIPC_BLOCK_FUNCTION Mask operator>=(Number a, Number b) { return {a.value >= b.value ? ~0u : 0}; }

// How many boxes are planned at once. Eight numbers are a vector of the compiler's own, so that no
// level of optimisation is needed; such vectors are passed by reference, since how a call passes
// them differs between processors.
struct One {
  using Floats = Number;
  using Masks = Mask;
  [[maybe_unused]] static constexpr std::size_t kCount = 1;
  static CLIPC_BLOCK_FUNCTION void KeepLarger(Masks& a, const Masks& b) {
    a.bits = a.bits < b.bits ? b.bits : a.bits;
  }
  static CLIPC_BLOCK_FUNCTION void Store(const Masks& plans, BoxPlan* to) {
    *to = static_cast<BoxPlan>(plans.bits);
  }
};
#if defined(__GNUC__)
struct Eight {
  using Floats = float __attribute__((vector_size(32)));
  using Masks = std::uint32_t __attribute__((vector_size(32)));
  static constexpr std::size_t kCount = 8;
  static CLIPC_BLOCK_FUNCTION void KeepLarger(Masks& a, const Masks& b) { a = a < b ? b : a; }
  static CLIPC_BLOCK_FUNCTION void Store(const Masks& plans, BoxPlan* to) {
    // In two steps: in one, a compiler takes each number by itself.
    using Halves = std::uint16_t __attribute__((vector_size(16)));
    using Bytes = BoxPlan __attribute__((vector_size(8)));
    const Halves halves = __builtin_convertvector(plans, Halves);
    const Bytes bytes = __builtin_convertvector(halves, Bytes);
    std::memcpy(to, &bytes, sizeof bytes);
  }
};
#else
using Eight = One;
#endif

template <typename To, typename From>
CLIPC_BLOCK_FUNCTION void CopyBits(const From& from, To& to) {
  static_assert(sizeof to == sizeof from);
  std::memcpy(&to, &from, sizeof to);
}

using Bounds = const float* [6];  // low x, y, z, high x, y, z

// A plane, and where the bounds of a box's corners are.
struct PlaneOfBoxes {
  Float4 plane;
  std::uint32_t bit = 0;
  bool is_zero = false;
  const float* nearest[3] = {};
  const float* farthest[3] = {};
};

float Magnitude(float number) { return number < 0 ? -number : number; }
Float4 Magnitudes(const Float4& p) {
  return {Magnitude(p.x), Magnitude(p.y), Magnitude(p.z), Magnitude(p.w)};
}

struct PlaneSet {
  PlaneSet(const Bounds& bounds, const Float4* from, std::size_t plane_count)
      : count(std::min<std::size_t>(plane_count, kMaxClipPlanes)) {
    for (std::size_t i = 0; i < count; ++i) {
      const Float4& p = from[i];
      const Float4 magnitudes = Magnitudes(p);
      size = {std::fmax(size.x, magnitudes.x), std::fmax(size.y, magnitudes.y),
              std::fmax(size.z, magnitudes.z), std::fmax(size.w, magnitudes.w)};
      const bool is_up[3] = {p.x >= 0, p.y >= 0, p.z >= 0};
      const bool is_zero = p.x == 0 && p.y == 0 && p.z == 0 && p.w == 0;
      // Adding 0 makes -0 to 0: no distance is -0 then.
      planes[i].plane = {p.x, p.y, p.z, p.w + 0};
      planes[i].bit = 1u << i, planes[i].is_zero = is_zero;
      for (int axis = 0; axis < 3; ++axis) {
        planes[i].nearest[axis] = bounds[is_up[axis] ? axis : axis + 3];
        planes[i].farthest[axis] = bounds[is_up[axis] ? axis + 3 : axis];
      }
    }
  }

  std::size_t count;
  PlaneOfBoxes planes[kMaxClipPlanes];
  Float4 size;  // the largest magnitude of each coefficient
};

// What E of kCount boxes is made of.
template <typename L>
struct Sizes {
  typename L::Floats largest[3];  // max(|low|, |high|)
  typename L::Floats flushed;  // what a distance may lose where the plane's coefficients become 0
  typename L::Masks in_order;  // low <= high on every axis: not so if one is NaN
};

template <typename L>
CLIPC_BLOCK_FUNCTION void Measure(const Bounds& bounds, std::size_t first, Sizes<L>& sizes) {
  typename L::Masks in_order[3];
  const auto measure = [&](int axis) {
    typename L::Floats low, high;
    std::memcpy(&low, bounds[axis] + first, sizeof low);
    std::memcpy(&high, bounds[axis + 3] + first, sizeof high);
    CopyBits(low <= high, in_order[axis]);
    // Magnitudes are in the order of their bits.
    typename L::Masks a, b;
    CopyBits(low, a), CopyBits(high, b);
    a = a & 0x7FFFFFFFu, b = b & 0x7FFFFFFFu;
    L::KeepLarger(a, b);
    CopyBits(a, sizes.largest[axis]);
  };
  measure(0), measure(1), measure(2);
  sizes.in_order = in_order[0] & in_order[1] & in_order[2];
  sizes.flushed = kLeastNormal * (sizes.largest[0] + sizes.largest[1] + sizes.largest[2]);
}

// Sets `error` to E for a plane whose coefficients have the magnitudes `size`: monotonic in each of
// them, roundings included; NaN, to which no distance compares, where sums are too large. `is_zero`
// is for the zero plane alone, which nothing rounds.
template <typename L>
CLIPC_BLOCK_FUNCTION void SetError(const Sizes<L>& sizes, const Float4& size, bool is_zero,
                                   typename L::Floats& error) {
  // Bounds that are flushed to 0 lose this; the coefficients' own loss is in the sizes.
  const float underflow = is_zero ? 0 : kFloatUnderflow + kLeastNormal * (size.x + size.y + size.z);
  const float share = is_zero ? 0.0f : 1.0f;
  error =
      size.x * sizes.largest[0] + size.y * sizes.largest[1] + size.z * sizes.largest[2] + size.w;
  error = kErrorFactor * error + (share * sizes.flushed + underflow);
  typename L::Masks bits, is_small;
  CopyBits(error, bits);
  CopyBits(error < kLargestBound, is_small);
  CopyBits(bits | ~is_small, error);  // all bits are a NaN
}

// Plans one plane for kCount boxes, with `error` for E: adds to `plans` its bit where it is needed
// and kCulled, and to `close` a highest bit where another E might answer otherwise, since a
// distance is nearer to 0 than E.
template <typename L>
CLIPC_BLOCK_FUNCTION void Plan(const PlaneOfBoxes& by, std::size_t first,
                               const typename L::Floats& error, typename L::Masks& plans,
                               typename L::Masks& close) {
  const Float4& plane = by.plane;
  const auto set_distance = [&](const float* const(&corner)[3], typename L::Floats& distance) {
    typename L::Floats x, y, z;
    std::memcpy(&x, corner[0] + first, sizeof x);
    std::memcpy(&y, corner[1] + first, sizeof y);
    std::memcpy(&z, corner[2] + first, sizeof z);
    distance = plane.x * x + plane.y * y + plane.z * z + plane.w;
  };
  typename L::Floats nearest, farthest;
  set_distance(by.nearest, nearest);
  set_distance(by.farthest, farthest);
  // All comparisons are false for NaN, which needs the plane.
  typename L::Masks is_in, is_out, signs;
  CopyBits(nearest >= error, is_in);
  CopyBits(farthest < -error, is_out);
  plans = plans | (~is_in & by.bit) | (is_out & std::uint32_t{kCulled});
  // In is positive, out is negative: else it is close.
  CopyBits(nearest, signs);
  close = close | ~(is_in ^ signs);
  CopyBits(farthest, signs);
  close = close | (is_out ^ signs);
}

template <typename L>
CLIPC_BLOCK_FUNCTION void StorePlans(const typename L::Masks& plans,
                                     const typename L::Masks& in_order, std::uint32_t all,
                                     BoxPlan* to) {
  // All bits where a box is not culled, and else kCulled.
  const typename L::Masks kept =
      (((plans & std::uint32_t{kCulled}) >> 7) - 1u) | std::uint32_t{kCulled};
  typename L::Masks every = {};
  every = ~every & all;
  L::Store((in_order & plans & kept) | (~in_order & every), to);
}

// As PlanBox says: each plane has its own E.
template <typename L>
CLIPC_BLOCK_FUNCTION void PlanExactly(const Bounds& bounds, std::size_t first, const PlaneSet& set,
                                      BoxPlan* to) {
  Sizes<L> sizes;
  Measure(bounds, first, sizes);
  typename L::Masks plans = {}, close = {};
  for (std::size_t i = 0; i < set.count; ++i) {
    typename L::Floats error;
    SetError(sizes, Magnitudes(set.planes[i].plane), set.planes[i].is_zero, error);
    Plan<L>(set.planes[i], first, error, plans, close);
  }
  StorePlans<L>(plans, sizes.in_order, (1u << set.count) - 1, to);
}

// Boxes whose bounds stay in the first-level cache for all planes.
constexpr std::size_t kChunk = 128;
static_assert(kChunk % Eight::kCount == 0);

// Plans `count` boxes of a chunk, a multiple of kCount.
template <typename L>
CLIPC_BLOCK_FUNCTION void PlanChunk(const Bounds& bounds, std::size_t first, std::size_t count,
                                    const PlaneSet& set, BoxPlan* to) {
  constexpr std::size_t kGroups = kChunk / L::kCount;
  const std::size_t groups = count / L::kCount;
  typename L::Floats errors[kGroups];
  typename L::Masks plans[kGroups], in_order[kGroups], close = {};
  // One error for all planes is less work, and hardly ever too large.
  for (std::size_t k = 0; k < groups; ++k) {
    Sizes<L> sizes;
    Measure(bounds, first + k * L::kCount, sizes);
    SetError(sizes, set.size, false, errors[k]);
    in_order[k] = sizes.in_order;
    plans[k] = typename L::Masks{};
  }
  for (std::size_t i = 0; i < set.count; ++i) {
    const PlaneOfBoxes by = set.planes[i];
    for (std::size_t k = 0; k < groups; ++k)
      Plan<L>(by, first + k * L::kCount, errors[k], plans[k], close);
  }
  std::uint32_t parts[L::kCount], any = 0;
  CopyBits(close, parts);
  for (const std::uint32_t part : parts) any |= part;
  for (std::size_t k = 0; k < groups; ++k) {
    BoxPlan* const at = to + k * L::kCount;
    if ((any >> 31) != 0)
      PlanExactly<L>(bounds, first + k * L::kCount, set, at);
    else
      StorePlans<L>(plans[k], in_order[k], (1u << set.count) - 1, at);
  }
}

CLIPC_BLOCK_FUNCTION void PlanArrays(const Bounds& bounds, std::size_t count, const Float4* planes,
                                     std::size_t plane_count, BoxPlan* plans) {
  const PlaneSet set(bounds, planes, plane_count);
  std::size_t first = 0;
  for (; count - first >= kChunk; first += kChunk)
    PlanChunk<Eight>(bounds, first, kChunk, set, plans + first);
  const std::size_t rest = count - first;
  if (rest == 0) return;
  float copies[6][kChunk] = {};
  for (int i = 0; i < 6; ++i) std::copy_n(bounds[i] + first, rest, copies[i]);
  const Bounds at = {copies[0], copies[1], copies[2], copies[3], copies[4], copies[5]};
  BoxPlan planned[kChunk];
  PlanChunk<Eight>(at, 0, kChunk, PlaneSet(at, planes, plane_count), planned);
  std::copy_n(planned, rest, plans + first);
}

#if CLIPC_HAS_AVX2_CLONE
__attribute__((target("avx2"))) void PlanForAvx2(const Bounds& bounds, std::size_t count,
                                                 const Float4* planes, std::size_t plane_count,
                                                 BoxPlan* plans) {
  PlanArrays(bounds, count, planes, plane_count, plans);
}
#endif

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
  const Bounds bounds = {&box.low[0],  &box.low[1],  &box.low[2],
                         &box.high[0], &box.high[1], &box.high[2]};
  BoxPlan plan;
  PlanExactly<One>(bounds, 0, PlaneSet(bounds, planes, plane_count), &plan);
  return plan;
}

void PlanBoxes(const BoxArrays& boxes, const Float4* planes, std::size_t plane_count,
               BoxPlan* plans) noexcept {
  const Bounds bounds = {boxes.low[0],  boxes.low[1],  boxes.low[2],
                         boxes.high[0], boxes.high[1], boxes.high[2]};
#if CLIPC_HAS_AVX2_CLONE
  if (__builtin_cpu_supports("avx2"))
    return PlanForAvx2(bounds, boxes.count, planes, plane_count, plans);
#endif
  PlanArrays(bounds, boxes.count, planes, plane_count, plans);
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
