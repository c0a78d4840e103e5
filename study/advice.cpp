// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/advice.h"

#include <algorithm>
#include <cmath>

#include "runtime/near_plane.h"
#include "study/law.h"

namespace clipc::study {
namespace {

// The law of a way in a draw: of the plane where it is largest.
runtime::EdgeDisplacement LawOf(const Way& way, const DrawFacts& facts) {
  runtime::EdgeDisplacement worst;
  for (const Setup& cut : facts.cuts) {
    const auto law = LawOf(cut, way, facts.means.order, facts.image_height);
    worst.along_surface = std::max(worst.along_surface, law.along_surface);
    worst.of_vertices = std::max(worst.of_vertices, law.of_vertices);
    worst.in_image = std::max(worst.in_image, law.in_image);
  }
  return worst;
}

bool IsPossible(const Way& way, const DrawFacts& facts) {
  const Means& means = facts.means;
  if (facts.planes > way.most_planes) return false;
  if (way.needs == Needs::kDistances && !means.clip_distances) return false;
  if (way.needs == Needs::kUserPlanes && !means.user_planes) return false;
  if (way.needs == Needs::kDiscard && !means.can_discard) return false;
  if (way.space == PlaneSpace::kObject && !means.rigid) return false;
  if (way.space == PlaneSpace::kXyw1 && facts.camera.orthographic) return false;
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

// Moves the origin of the mesh to each cut.
void MoveOrigins(DrawFacts& facts) {
  for (Setup& cut : facts.cuts) {
    const std::vector<Vector> places = RandomCuts(cut, 1);
    if (places.empty()) continue;
    const Vector place = places.front();
    const Vec4<double> to =
        Transform(Transform(Vec4<double>{{place.x, place.y, place.z, 1}}, cut.to_object),
                  ConvertTo<double>(cut.world));
    for (int i = 0; i < 3; ++i) cut.world.m[3][i] = to[i];
    Compose(cut);
  }
}

void ReverseDepth(DrawFacts& facts) {
  facts.camera.reversed = true;
  for (Setup& cut : facts.cuts) {
    cut.config.camera.reversed = true;
    cut.projection = facts.camera.Projection();
    Compose(cut);
  }
}

}  // namespace

std::vector<Advice> Advise(const DrawFacts& facts, const CostTable& costs, double tolerance) {
  std::vector<Advice> all;
  std::map<Method (*)(), runtime::EdgeDisplacement> laws;  // of ways that have the same arithmetic
  for (const Way& way : kWays) {
    if (way.kind == WayKind::kNone || way.kind == WayKind::kNearPlaneFloat) continue;
    Advice& advice = all.emplace_back(Advice{way.name});
    advice.possible = IsPossible(way, facts);
    advice.cost = CostOf(way.name, facts.planes, costs);
    advice.predicted = INFINITY;
    if (advice.possible) {
      const auto [law, is_new] = laws.try_emplace(way.method);
      if (is_new) law->second = LawOf(way, facts);
      advice.along_surface = law->second.along_surface, advice.in_image = law->second.in_image;
      advice.predicted = law->second.In(facts.judged_in);
    }
    advice.bound = kBound * advice.predicted;
    advice.meets = advice.possible && advice.bound <= tolerance;
  }
  double least = INFINITY;
  for (const Advice& a : all) {
    if (a.meets) least = std::min(least, a.cost);
  }
  const auto rank = [&](const Advice& a) {
    if (!a.possible) return 4;
    if (!a.meets) return 3;
    if (!a.has_cost()) return 2;
    return a.cost <= least * (1 + kSameCost) ? 0 : 1;
  };
  // The order of the ways decides between equals.
  std::ranges::stable_sort(all, [&](const Advice& a, const Advice& b) {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    if (rank(a) == 1) return a.cost < b.cost;
    const double least_seen = rank(a) < 3 ? kInvisible : 0;
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
  if (helps(MoveOrigins))
    return "its vertices are far from their own origin: give the mesh one of its own";
  if (helps([](DrawFacts& f) { f.means.order = runtime::MatrixOrder::kOneMatrix; }))
    return "far from the world's origin: multiply its matrices in double, or let the world begin "
           "at the camera";
  if (!facts.camera.reversed && helps(ReverseDepth)) return "reverse the depth";
  return "";
}

}  // namespace clipc::study
