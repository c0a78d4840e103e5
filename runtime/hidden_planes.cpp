// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/hidden_planes.h"

#include <algorithm>
#include <cmath>

#include "clip-table/vocabulary.h"

namespace clipc::runtime {
namespace {

// E of PlanBox, in double; and a sum from which on it is not judged.
constexpr double kErrorShare = 10 * 0x1p-24;
constexpr double kErrorUnderflow = 0x1p-120, kErrorFlushed = 0x1p-126;
constexpr double kMostJudged = 0x1p120;

struct BoundedPlane {
  double normal[3] = {};
  double offset = 0, error = 0;
  bool is_judged = false;
};

BoundedPlane BoundOf(const Float4& plane, const double (&low)[3], const double (&high)[3]) {
  BoundedPlane bounded = {
      {static_cast<double>(plane.x), static_cast<double>(plane.y), static_cast<double>(plane.z)},
      static_cast<double>(plane.w)};
  double sum = std::fabs(bounded.offset), flushed = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double n = std::fabs(bounded.normal[axis]);
    const double largest = std::max(std::fabs(low[axis]), std::fabs(high[axis]));
    sum += n * largest;
    flushed += n + largest;
  }
  bounded.error = kErrorShare * sum + kErrorUnderflow + kErrorFlushed * flushed;
  bounded.is_judged = sum < kMostJudged;
  return bounded;
}

// A search for weights with which `count` planes hide another.
class Hiding {
 public:
  Hiding(const Box& box, const Float4* planes, std::size_t plane_count) {
    for (int axis = 0; axis < 3; ++axis) {
      low_[axis] = static_cast<double>(box.low[axis]);
      high_[axis] = static_cast<double>(box.high[axis]);
    }
    for (std::size_t i = 0; i < plane_count; ++i) planes_[i] = BoundOf(planes[i], low_, high_);
  }

  // Whether planes of the mask hide the plane i; or, with `other_side`, its other side.
  bool IsHidden(std::size_t i, std::uint32_t by, bool other_side = false) const {
    BoundedPlane hidden = planes_[i];
    if (!hidden.is_judged) return false;
    if (other_side) {
      hidden.offset = -hidden.offset;
      for (double& n : hidden.normal) n = -n;
    }
    const BoundedPlane* others[kMaxClipPlanes];
    std::size_t count = 0;
    for (std::size_t j = 0; j < kMaxClipPlanes; ++j) {
      if ((by >> j & 1) != 0 && planes_[j].is_judged) others[count++] = &planes_[j];
    }
    for (std::size_t a = 0; a < count; ++a) {
      if (HidesAlone(hidden, *others[a])) return true;
      for (std::size_t b = a + 1; b < count; ++b) {
        if (HideTogether(hidden, *others[a], *others[b])) return true;
        for (std::size_t c = b + 1; c < count; ++c) {
          if (HideTogether(hidden, *others[a], *others[b], *others[c])) return true;
        }
      }
    }
    return false;
  }

 private:
  // Whether these weights prove that the plane is hidden. Where they are best, the sum does not
  // depend on as many axes as there are weights.
  template <std::size_t kCount>
  bool Prove(const BoundedPlane& hidden, const BoundedPlane* const (&by)[kCount],
             const double (&weights)[kCount]) const {
    double most = hidden.error - hidden.offset;
    double slope[3] = {-hidden.normal[0], -hidden.normal[1], -hidden.normal[2]};
    for (std::size_t j = 0; j < kCount; ++j) {
      if (!(weights[j] >= 0)) return false;
      most += weights[j] * (by[j]->offset + by[j]->error);
      for (int axis = 0; axis < 3; ++axis) slope[axis] += weights[j] * by[j]->normal[axis];
    }
    for (int axis = 0; axis < 3; ++axis)
      most += std::max(slope[axis] * low_[axis], slope[axis] * high_[axis]);
    return most < 0;
  }

  bool HidesAlone(const BoundedPlane& hidden, const BoundedPlane& by) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (Prove<1>(hidden, {&by}, {hidden.normal[axis] / by.normal[axis]})) return true;
    }
    return false;
  }

  bool HideTogether(const BoundedPlane& hidden, const BoundedPlane& a,
                    const BoundedPlane& b) const {
    for (int axis = 0; axis < 3; ++axis) {
      const int x = (axis + 1) % 3, y = (axis + 2) % 3;
      const double determinant = a.normal[x] * b.normal[y] - a.normal[y] * b.normal[x];
      const double of_a = hidden.normal[x] * b.normal[y] - hidden.normal[y] * b.normal[x];
      const double of_b = a.normal[x] * hidden.normal[y] - a.normal[y] * hidden.normal[x];
      if (Prove<2>(hidden, {&a, &b}, {of_a / determinant, of_b / determinant})) return true;
    }
    return false;
  }

  bool HideTogether(const BoundedPlane& hidden, const BoundedPlane& a, const BoundedPlane& b,
                    const BoundedPlane& c) const {
    const auto volume = [](const BoundedPlane& p, const BoundedPlane& q, const BoundedPlane& r) {
      const auto &x = p.normal, &y = q.normal, &z = r.normal;
      return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) +
             x[2] * (y[0] * z[1] - y[1] * z[0]);
    };
    const double determinant = volume(a, b, c);
    return Prove<3>(hidden, {&a, &b, &c},
                    {volume(hidden, b, c) / determinant, volume(a, hidden, c) / determinant,
                     volume(a, b, hidden) / determinant});
  }

  double low_[3], high_[3];
  BoundedPlane planes_[kMaxClipPlanes];
};

}  // namespace

BoxPlan WithoutHiddenPlanes(const Box& box, const Float4* planes, std::size_t plane_count,
                            BoxPlan plan) noexcept {
  if ((plan & kCulled) != 0 || (plan & (plan - 1)) == 0) return plan;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.low[axis] <= box.high[axis])) return plan;
  }
  plane_count = std::min<std::size_t>(plane_count, kMaxClipPlanes);
  const Hiding hiding(box, planes, plane_count);
  std::uint32_t kept = plan;
  for (std::size_t i = 0; i < plane_count; ++i) {
    const std::uint32_t others = kept & ~(std::uint32_t{1} << i);
    if (others == kept || !hiding.IsHidden(i, others)) continue;
    kept = others;
  }
  for (std::size_t i = 0; i < plane_count; ++i) {
    const std::uint32_t others = kept & ~(std::uint32_t{1} << i);
    if (others != kept && others != 0 && hiding.IsHidden(i, others, true)) return kCulled;
  }
  return static_cast<BoxPlan>(kept);
}

}  // namespace clipc::runtime
