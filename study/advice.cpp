// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/advice.h"

#include <algorithm>
#include <cmath>

#include "runtime/near_plane.h"
#include "runtime/plane_space.h"
#include "study/way.h"

namespace clipc::study {
namespace {

using enum PlaneSpace;

// The multiple of the law that one plane's error is below, whatever its luck: a way whose law is so
// far below the tolerance need not be measured. An error may be below the law by any factor, as a
// corner of the cut may be much nearer than the rest.
constexpr double kMostOfLaw = 12;

double LawOfCut(const Way& way, const DrawFacts& facts, const CutFacts& cut) {
  // The cut becomes a float vertex, and the error is its rounding.
  if (way.kind == WayKind::kCpu)
    return 2 * 0x1p-24 * facts.picture_height / 2 * (0.5 + cut.reach + facts.extent / 2);
  const Matrix projection = facts.camera.Projection();
  const auto law = [&](PlaneSpace space, double reach) {
    const auto pixels = PredictEdgeError(space, cut.view_plane, projection, facts.picture_height,
                                         facts.sine, reach);
    return pixels.ok() ? pixels.value * LengthFactor(facts.extent) : INFINITY;
  };
  const double world_reach = std::max(cut.reach, cut.world_reach);
  // Distances by hand are as good as in object space, and twice rounded: the world-space vertex is,
  // and its dot product with the plane.
  if (!way.space) return 2 * law(kObject, world_reach);
  const double own = law(*way.space, cut.reach);
  if (way.space == kObject) return own;
  using enum runtime::MatrixOrder;
  switch (facts.means.order) {
    case kWorldFirst:
    case kFloatViewProjection: return law(*way.space, world_reach);
    case kThreeMatrices:
    case kFloatWorldView:
      return std::max(own, law(facts.camera.orthographic ? kClip : kXyw1, world_reach));
    default: return own;
  }
}

double LawOf(const Way& way, const DrawFacts& facts) {
  double worst = 0;
  for (const CutFacts& cut : facts.cuts) worst = std::max(worst, LawOfCut(way, facts, cut));
  return worst;
}

bool IsPossible(const Way& way, const DrawFacts& facts) {
  const Means& means = facts.means;
  if (facts.planes > way.most_planes) return false;
  if (way.needs == Needs::kDistances && !means.clip_distances) return false;
  if (way.needs == Needs::kUserPlanes && !means.user_planes) return false;
  if (way.needs == Needs::kDiscard && !means.can_discard) return false;
  if (way.space == kObject && !means.rigid) return false;
  if (way.space == kXyw1 && facts.camera.orthographic) return false;
  if (way.kind != WayKind::kNearPlane) return true;
  if (!means.whole_pass) return false;
  // The lowering writes z = d, which is the near plane where z = 0 is near.
  return !facts.camera.reversed && !facts.cuts.empty() &&
         ShearNearPlane(facts.cuts.front().view_plane, facts.camera.Projection(),
                        facts.camera.Range(), runtime::NearPlaneScale::kKeepFar)
             .ok();
}

double CostOf(const std::string& way, int planes, const CostTable& costs) {
  double cost = INFINITY;
  for (auto it = costs.begin(); it != costs.end(); ++it) {
    // The table has 1, 3 and 6 planes: the first number that is enough counts.
    if (it->first.first == way && it->first.second >= planes) return it->second;
  }
  return cost;
}

}  // namespace

std::vector<Advice> Advise(const DrawFacts& facts, const CostTable& costs, double tolerance,
                           const Measure& measure) {
  std::vector<Advice> all;
  for (const Way& way : kWays) {
    if (way.kind == WayKind::kNone || way.kind == WayKind::kNearPlaneFloat) continue;
    Advice& advice = all.emplace_back();
    advice.way = way.name;
    advice.possible = IsPossible(way, facts);
    advice.predicted = LawOf(way, facts);
    advice.bound = kBoundFactor * advice.predicted;
    const bool is_open = advice.possible && kMostOfLaw * advice.predicted > tolerance;
    if (const auto measured = is_open && measure ? measure(way) : std::nullopt) {
      advice.predicted = *measured;
      advice.bound = kMeasuredFactor * *measured;
    }
    advice.cost = CostOf(way.name, facts.planes, costs);
    advice.meets = advice.possible && advice.bound <= tolerance && std::isfinite(advice.cost);
  }
  double least = INFINITY;
  for (const Advice& a : all) {
    if (a.meets) least = std::min(least, a.cost);
  }
  const auto rank = [&](const Advice& a) {
    if (!a.possible) return 3;
    if (!a.meets) return 2;
    return a.cost <= least * (1 + kSameCost) ? 0 : 1;
  };
  // The order of the ways decides between equals.
  std::ranges::stable_sort(all, [&](const Advice& a, const Advice& b) {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    if (rank(a) == 1) return a.cost < b.cost;
    const double least_seen = rank(a) == 0 ? kInvisible : 0;
    return std::max(a.predicted, least_seen) < std::max(b.predicted, least_seen);
  });
  return all;
}

std::string CureFor(const DrawFacts& facts, const CostTable& costs, double tolerance) {
  const auto helps = [&](auto change) {
    DrawFacts changed = facts;
    change(changed);
    return Advise(changed, costs, tolerance).front().meets;
  };
  const auto around_its_origin = [](DrawFacts& f) {
    for (CutFacts& cut : f.cuts) cut.reach = std::min(cut.reach, runtime::kAroundOrigin);
  };
  if (helps(around_its_origin))
    return "its vertices are far from their own origin: give the mesh one of its own";
  if (helps([](DrawFacts& f) { f.means.order = runtime::MatrixOrder::kOneMatrix; }))
    return "far from the world's origin: multiply its matrices in double, or let the world begin "
           "at the camera";
  if (!facts.camera.reversed && helps([](DrawFacts& f) { f.camera.reversed = true; }))
    return "reverse the depth";
  return "";
}

}  // namespace clipc::study
