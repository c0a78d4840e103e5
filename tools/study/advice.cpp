// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/study/advice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "runtime/near_plane.h"
#include "runtime/plane_space.h"
#include "tools/study/way.h"

namespace clipc::study {
namespace {

using enum PlaneSpace;

double LawOf(std::optional<PlaneSpace> space, const DrawFacts& facts) {
  const Matrix projection = facts.camera.Projection();
  const auto law = [&](PlaneSpace of) {
    return runtime::PredictEdgeError(of, facts.view_plane, projection, facts.picture_height,
                                     facts.sine)
        .value;
  };
  if (space) return law(*space);
  const double floor = law(facts.camera.orthographic ? kObject : kXyw1);
  // World coordinates carry the offset's rounding: as many units as it is larger than what is seen.
  const double size = facts.camera.orthographic ? facts.camera.half_height : facts.depth;
  return floor * (1 + facts.world_offset / size);
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
  // The lowering writes z = d, which is the near plane where z = 0 is near.
  return !facts.camera.reversed &&
         ShearNearPlane(facts.view_plane, facts.camera.Projection(), facts.camera.Range(),
                        runtime::NearPlaneScale::kKeepFar)
             .ok();
}

double CostOf(const std::string& way, int planes, const CostTable& costs) {
  double cost = std::numeric_limits<double>::infinity();
  for (auto it = costs.begin(); it != costs.end(); ++it) {
    // The table has 1, 3 and 6 planes: the first that is enough.
    if (it->first.first == way && it->first.second >= planes) return it->second;
  }
  return cost;
}

}  // namespace

std::vector<Advice> Advise(const DrawFacts& facts, const CostTable& costs, double tolerance) {
  std::vector<Advice> all;
  for (const Way& way : kWays) {
    if (way.kind == WayKind::kNone || way.kind == WayKind::kNearPlaneFloat) continue;
    Advice& advice = all.emplace_back();
    advice.way = way.name;
    advice.possible = IsPossible(way, facts);
    advice.predicted = LawOf(way.space, facts) * LengthFactor(facts.extent);
    advice.bound = kBoundFactor * advice.predicted;
    advice.cost = CostOf(way.name, facts.planes, costs);
  }
  const auto admissible = [&](const Advice& a) {
    return a.possible && a.bound <= tolerance && std::isfinite(a.cost);
  };
  double least = std::numeric_limits<double>::infinity();
  for (const Advice& a : all) {
    if (admissible(a)) least = std::min(least, a.cost);
  }
  const auto rank = [&](const Advice& a) {
    if (!a.possible) return 3;
    if (!admissible(a)) return 2;
    return a.cost <= least * (1 + kSameCost) ? 0 : 1;
  };
  std::ranges::stable_sort(all, [&](const Advice& a, const Advice& b) {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    if (rank(a) == 1) return a.cost < b.cost;
    return a.bound != b.bound ? a.bound < b.bound : a.cost < b.cost;
  });
  return all;
}

}  // namespace clipc::study
