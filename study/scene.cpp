// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

#include "runtime/clip_plane.h"
#include "study/numbers.h"
#include "study/setup.h"
#include "study/visible_cut.h"
#include "study/way.h"
#include "tools/harness/scenes.h"

namespace clipc::study {
namespace {

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

Vector CornerOf(const runtime::Box& box, int corner) {
  const auto at = [&](int axis) {
    return static_cast<double>((corner >> axis & 1) != 0 ? box.high[axis] : box.low[axis]);
  };
  return {at(0), at(1), at(2)};
}

Vector Through(const Matrix& matrix, Vector p) {
  const auto& m = matrix.m;
  const auto at = [&](int j) { return p.x * m[0][j] + p.y * m[1][j] + p.z * m[2][j] + m[3][j]; };
  return {at(0), at(1), at(2)};
}

// The draw of one plane through an object, with the part of its cut that is seen and that the other
// planes, in world space, keep; none where no part is, or where the plane has no normal.
std::optional<Setup> SetupOf(const Camera& camera, const SceneObject& object, const Plane& plane,
                             const std::vector<Plane>& others) {
  Setup setup;
  setup.config.camera = camera;
  setup.world = object.world, setup.view = camera.View(), setup.projection = camera.Projection();
  Compose(setup);
  setup.world_plane = plane;
  setup.view_plane = PlaneBefore(camera.ViewToWorld(), plane);
  setup.object_plane = PlaneBefore(setup.world, plane);
  const Plane& v = setup.view_plane;
  const double length = NormalLength(v);
  if (!(length > 0)) return std::nullopt;
  setup.config.view_plane = {v.x / length, v.y / length, v.z / length, v.w / length};

  double nearest = INFINITY, farthest = camera.near, diagonal = 0;
  const Vector first = Through(setup.world_view, CornerOf(object.box, 0));
  for (int corner = 0; corner < 8; ++corner) {
    const Vector place = Through(setup.world_view, CornerOf(object.box, corner));
    nearest = std::min(nearest, place.z), farthest = std::max(farthest, place.z);
    diagonal = std::max(diagonal, std::sqrt(Dot(place - first, place - first)));
  }
  nearest = std::max(nearest, camera.near);
  if (!camera.infinite) farthest = std::min(farthest, camera.far);
  if (!(farthest > nearest)) return std::nullopt;
  setup.cut = CutOfBox(VisibleCut(camera, setup.config.view_plane, nearest, farthest), object.box,
                       setup.world_view);
  for (const Plane& other : others)
    setup.cut = KeptBy(setup.cut, PlaneBefore(camera.ViewToWorld(), other));
  if (setup.cut.size() < 3) return std::nullopt;
  // Edges as long as a twentieth of the depth, or as half the object where that is less.
  const double depth = camera.orthographic ? camera.half_height : setup.cut.front().z;
  setup.config.edge_length = std::min(0.05, diagonal / 2 / depth);
  return setup;
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
    if (scene.name == "cascade") scene.image_height = 2048;  // of a shadow map
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
  facts.image_height = scene.image_height;
  facts.judged_in = scene.judged_in;
  facts.means = scene.means;
  facts.means.rigid = object.rigid;
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    if ((needed >> i & 1) == 0) continue;
    std::vector<Plane> others;
    for (std::size_t j = 0; j < scene.planes.size(); ++j) {
      if (j != i && (needed >> j & 1) != 0) others.push_back(scene.planes[j].plane);
    }
    if (auto cut = SetupOf(camera, object, scene.planes[i].plane, others))
      facts.cuts.push_back(std::move(*cut));
  }
  return facts;
}

std::vector<ObjectAdvice> AdviseScene(const Scene& scene, const Camera& camera,
                                      const CostTable& costs,
                                      const std::function<void(double)>& progress) {
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
      if (progress) progress(static_cast<double>(i) / static_cast<double>(all.size()));
      const ObjectPlan& plan = all[i].plan;
      if (!plan.drawn() || plan.needed == 0) continue;
      DrawFacts facts = FactsOf(scene.objects[i], camera, scene, plan.needed);
      facts.means.whole_pass = whole_pass;
      all[i].best = Advise(facts, costs, scene.tolerance).front();
      if (!all[i].best->meets) all[i].cure = CureFor(facts, costs, scene.tolerance);
      is_shared = is_shared && all[i].best->way == "near-plane";
    }
    if (whole_pass && is_shared) break;
  }
  return all;
}

}  // namespace clipc::study
