// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/study/advice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/near_plane.h"
#include "runtime/plane_space.h"

namespace clipc::study {
namespace {

using runtime::PlaneSpace;

enum class Arithmetic { kClip, kXyw1, kObject, kWorld };

struct Known {
  const char* way;
  Arithmetic arithmetic;
  enum class Needs { kDistances, kUserPlanes, kDiscard, kNothing } needs;
  int most_planes = 6;
};
constexpr Known kKnown[] = {{"clip", Arithmetic::kClip, Known::Needs::kDistances},
                            {"xyw1", Arithmetic::kXyw1, Known::Needs::kDistances},
                            {"object", Arithmetic::kObject, Known::Needs::kDistances},
                            {"world", Arithmetic::kWorld, Known::Needs::kDistances},
                            {"level9", Arithmetic::kClip, Known::Needs::kUserPlanes},
                            {"near-plane", Arithmetic::kObject, Known::Needs::kNothing, 1},
                            {"discard", Arithmetic::kClip, Known::Needs::kDiscard},
                            {"discard-object", Arithmetic::kObject, Known::Needs::kDiscard},
                            {"discard-world", Arithmetic::kWorld, Known::Needs::kDiscard},
                            {"cpu", Arithmetic::kObject, Known::Needs::kNothing}};

double LawOf(Arithmetic arithmetic, const DrawFacts& facts) {
  const runtime::Matrix projection = facts.camera.Projection();
  const auto law = [&](PlaneSpace space) {
    return runtime::PredictEdgeError(space, facts.view_plane, projection, facts.picture_height,
                                     facts.sine)
        .value;
  };
  if (arithmetic == Arithmetic::kClip) return law(PlaneSpace::kClip);
  if (arithmetic == Arithmetic::kXyw1) return law(PlaneSpace::kXyw1);
  if (arithmetic == Arithmetic::kObject) return law(PlaneSpace::kObject);
  const double floor = law(facts.camera.orthographic ? PlaneSpace::kObject : PlaneSpace::kXyw1);
  // World coordinates carry the offset's rounding: as many units as it is larger than what is seen.
  const double size = facts.camera.orthographic ? facts.camera.half_height : facts.depth;
  return floor * (1 + facts.world_offset / size);
}

bool IsPossible(const Known& known, const DrawFacts& facts) {
  const Means& means = facts.means;
  if (facts.planes > known.most_planes) return false;
  if (known.needs == Known::Needs::kDistances && !means.clip_distances) return false;
  if (known.needs == Known::Needs::kUserPlanes && !means.user_planes) return false;
  if (known.needs == Known::Needs::kDiscard && !means.can_discard) return false;
  if (known.arithmetic == Arithmetic::kObject && !means.rigid) return false;
  if (known.arithmetic == Arithmetic::kXyw1 && facts.camera.orthographic) return false;
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
    advice.predicted = LawOf(known.arithmetic, facts) * LengthFactor(facts.extent);
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
