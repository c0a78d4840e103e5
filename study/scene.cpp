// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>

#include "runtime/clip_plane.h"
#include "study/numbers.h"
#include "study/scene_measure.h"
#include "study/setup.h"
#include "study/visible_cut.h"
#include "study/way.h"
#include "tools/harness/scenes.h"

namespace clipc::study {
namespace {

// The numbers of edges to measure: kFewEdges where their error is far from the tolerance, and
// kEdges where it is not.
constexpr long kFewEdges = 400, kEdges = 2000;

// A plane of clip space lies in the object's own space at the whole matrix times the plane. It is
// rounded to float and pushed outwards by as much as the rounding may have moved it.
bool IsOutsideFrustum(const SceneObject& object, const Camera& camera) {
  const Matrix m = Multiply(Multiply(object.world, camera.View()), camera.Projection());
  const Plane sides[] = {{1, 0, 0, 1},  {-1, 0, 0, 1}, {0, 1, 0, 1},
                         {0, -1, 0, 1}, {0, 0, 1, 0},  {0, 0, -1, 1}};
  for (const Plane& side : sides) {
    const Plane plane = PlaneBefore(m, side);
    double reach = std::fabs(plane.w);
    const double c[3] = {plane.x, plane.y, plane.z};
    for (int i = 0; i < 3; ++i) {
      reach += std::fabs(c[i]) * static_cast<double>(std::max(std::fabs(object.box.low[i]),
                                                              std::fabs(object.box.high[i])));
    }
    const runtime::Float4 outwards = {static_cast<float>(plane.x), static_cast<float>(plane.y),
                                      static_cast<float>(plane.z),
                                      static_cast<float>(plane.w + 1e-6 * reach)};
    if (PlanBox(object.box, &outwards, 1) == runtime::kCulled) return true;
  }
  return false;
}

// The error of a way, measured with as many edges as it takes to hold it against the tolerance.
std::optional<double> MeasureRoughly(const Scene& scene, const Camera& camera,
                                     const SceneObject& object, std::uint8_t needed,
                                     const Way& way) {
  const auto lost = MeasureObject(scene, camera, object, needed, way, kFewEdges, 1);
  if (!lost || *lost < scene.tolerance / 6 || *lost > 3 * scene.tolerance) return lost;
  return MeasureObject(scene, camera, object, needed, way, kEdges, 1);
}

// The largest distance of these places from an origin, in heights of the picture at their depth.
double FarthestReach(const Camera& camera, const std::vector<Vector>& cut, Vector origin) {
  double reach = 0;
  for (const Vector& place : cut) {
    const Vector away = place - origin;
    reach = std::max(reach, std::sqrt(Dot(away, away)) / (2 * camera.HalfHeightAt(place.z)));
  }
  return reach;
}

double Middle(const runtime::Box& box, int axis) {
  return (static_cast<double>(box.low[axis]) + static_cast<double>(box.high[axis])) / 2;
}

}  // namespace

std::vector<Scene> BuiltInScenes() {
  std::vector<Scene> scenes;
  for (const harness::Scene& built_in : harness::BuiltInScenes()) {
    Scene& scene = scenes.emplace_back();
    scene.name = built_in.name;
    scene.cameras = {{"main", built_in.camera}};
    for (const Plane& plane : built_in.planes) scene.planes.push_back({"", plane});
    for (const harness::SceneObject& object : built_in.objects)
      scene.objects.push_back({"", object.box, object.world});
    if (scene.name == "cascade") scene.picture_height = 2048;  // of a shadow map
  }
  return scenes;
}

ObjectPlan PlanObject(const SceneObject& object, const Camera& camera,
                      const std::vector<NamedPlane>& planes) {
  ObjectPlan plan;
  plan.outside_frustum = IsOutsideFrustum(object, camera);
  std::vector<runtime::Float4> constants;
  for (const NamedPlane& plane : planes) {
    const auto constant = ObjectPlaneFromWorld(plane.plane, object.world);
    if (!constant.ok() && plan.refused.empty())
      plan.refused = plane.name + ": " + constant.status.message();
    constants.push_back(constant.value.constant);
  }
  if (!plan.refused.empty()) return plan;
  const runtime::BoxPlan needed = PlanBox(object.box, constants.data(), constants.size());
  plan.culled = needed == runtime::kCulled;
  plan.needed = plan.culled ? 0 : needed;
  return plan;
}

DrawFacts FactsOf(const SceneObject& object, const Camera& camera, const Scene& scene,
                  std::uint8_t needed) {
  DrawFacts facts;
  facts.camera = camera;
  facts.planes = std::max(1, std::popcount(needed));
  facts.picture_height = scene.picture_height;
  facts.means = scene.means;
  facts.means.rigid = object.rigid;
  const Matrix view = camera.View();
  const Vec4<double> middle = {
      {Middle(object.box, 0), Middle(object.box, 1), Middle(object.box, 2), 1}};
  const Vec4<double> in_world = Transform(middle, ConvertTo<double>(object.world));
  const Vec4<double> in_view = Transform(in_world, ConvertTo<double>(view));
  const double depth = std::max(in_view[2], camera.near);
  double diagonal = 0;
  for (int j = 0; j < 3; ++j) {
    double side = 0;
    for (int i = 0; i < 3; ++i) {
      side += (static_cast<double>(object.box.high[i]) - static_cast<double>(object.box.low[i])) *
              std::fabs(object.world.m[i][j]);
    }
    diagonal += side * side;
  }
  const double size = std::sqrt(diagonal);
  facts.extent = size / camera.HalfHeightAt(depth);
  const Matrix world_view = Multiply(object.world, view);
  const double farthest = camera.infinite ? depth + size : std::min(camera.far, depth + size);
  facts.cuts.clear();
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    if ((needed >> i & 1) == 0) continue;
    const auto plane = ViewPlaneFromWorld(scene.planes[i].plane, view);
    if (!plane.ok() || !(NormalLength(plane.value.plane) > 0)) continue;
    CutFacts& cut = facts.cuts.emplace_back(CutFacts{plane.value.plane});
    // The visible part of the cut inside the object's box; the object's middle where there is none.
    std::vector<Vector> seen = CutOfBox(
        VisibleCut(camera, cut.view_plane, camera.near, std::max(farthest, 2 * camera.near)),
        object.box, world_view);
    if (seen.empty()) seen.push_back({in_view[0], in_view[1], depth});
    cut.reach = FarthestReach(camera, seen, OriginInView(world_view));
    cut.world_reach = FarthestReach(camera, seen, OriginInView(view));
  }
  return facts;
}

std::vector<ObjectAdvice> AdviseScene(const Scene& scene, const Camera& camera,
                                      const CostTable& costs) {
  std::vector<ObjectAdvice> all;
  std::uint8_t needed_by_all = 0xff, needed_by_any = 0;
  for (const SceneObject& object : scene.objects) {
    const ObjectPlan& plan =
        all.emplace_back(ObjectAdvice{PlanObject(object, camera, scene.planes), {}, {}}).plan;
    if (!plan.drawn()) continue;
    needed_by_all &= plan.needed, needed_by_any |= plan.needed;
  }
  const bool is_one = needed_by_all == needed_by_any && std::has_single_bit(needed_by_any);
  for (const bool whole_pass : {true, false}) {
    if (whole_pass && !is_one) continue;
    bool is_shared = true;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const ObjectPlan& plan = all[i].plan;
      if (!plan.drawn() || plan.needed == 0) continue;
      DrawFacts facts = FactsOf(scene.objects[i], camera, scene, plan.needed);
      facts.means.whole_pass = whole_pass;
      // Ways of the same arithmetic have the same error.
      std::map<Method (*)(), std::optional<double>> known;
      const Measure measure = [&](const Way& way) {
        const auto [found, is_new] = known.try_emplace(way.method);
        if (is_new)
          found->second = MeasureRoughly(scene, camera, scene.objects[i], plan.needed, way);
        return found->second;
      };
      all[i].best = Advise(facts, costs, scene.tolerance, measure).front();
      if (!all[i].best->meets) all[i].cure = CureFor(facts, costs, scene.tolerance);
      is_shared = is_shared && all[i].best->way == "near-plane";
    }
    if (whole_pass && is_shared) break;
  }
  return all;
}

}  // namespace clipc::study
