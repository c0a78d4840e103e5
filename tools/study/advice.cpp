// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/study/advice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "runtime/near_plane.h"
#include "runtime/plane_space.h"

namespace clipc::study {
namespace {

using runtime::PlaneSpace;

enum class Needs { kDistances, kUserPlanes, kDiscard, kNothing };

struct Known {
  const char* way;
  std::optional<PlaneSpace> space;  // of the planes; none: the world's
  Needs needs;
  int most_planes = 6;
};
using enum PlaneSpace;
using enum Needs;
constexpr Known kKnown[] = {{"clip", kClip, kDistances},
                            {"xyw1", kXyw1, kDistances},
                            {"object", kObject, kDistances},
                            {"world", std::nullopt, kDistances},
                            {"level9", kClip, kUserPlanes},
                            {"near-plane", kObject, kNothing, 1},
                            {"discard", kClip, kDiscard},
                            {"discard-object", kObject, kDiscard},
                            {"discard-world", std::nullopt, kDiscard},
                            {"cpu", kObject, kNothing}};

double LawOf(std::optional<PlaneSpace> space, const DrawFacts& facts) {
  const runtime::Matrix projection = facts.camera.Projection();
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

bool IsPossible(const Known& known, const DrawFacts& facts) {
  const Means& means = facts.means;
  if (facts.planes > known.most_planes) return false;
  if (known.needs == kDistances && !means.clip_distances) return false;
  if (known.needs == kUserPlanes && !means.user_planes) return false;
  if (known.needs == kDiscard && !means.can_discard) return false;
  if (known.space == kObject && !means.rigid) return false;
  if (known.space == kXyw1 && facts.camera.orthographic) return false;
  if (std::string(known.way) != "near-plane") return true;
  // The lowering writes z = d, which is the near plane where z = 0 is near.
  return !facts.camera.reversed &&
         runtime::ShearNearPlane(facts.view_plane, facts.camera.Projection(), facts.camera.Range(),
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
  for (const Known& known : kKnown) {
    Advice& advice = all.emplace_back();
    advice.way = known.way;
    advice.possible = IsPossible(known, facts);
    advice.predicted = LawOf(known.space, facts) * LengthFactor(facts.extent);
    advice.bound = kBoundFactor * advice.predicted;
    advice.cost = CostOf(known.way, facts.planes, costs);
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
  std::stable_sort(all.begin(), all.end(), [&](const Advice& a, const Advice& b) {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    if (rank(a) == 1) return a.cost < b.cost;
    return a.bound != b.bound ? a.bound < b.bound : a.cost < b.cost;
  });
  return all;
}

}  // namespace clipc::study
