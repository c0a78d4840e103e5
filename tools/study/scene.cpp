// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/study/scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "runtime/clip_plane.h"
#include "tools/study/numbers.h"
#include "tools/study/scene_measure.h"
#include "tools/study/setup.h"
#include "tools/study/visible_cut.h"
#include "tools/study/way.h"

namespace clipc::study {
namespace {

constexpr int kObjects = 1000;
// The numbers of edges to measure: kFewEdges where their error is far from the tolerance, and
// kEdges where it is not.
constexpr long kFewEdges = 400, kEdges = 2000;

// The place and the size of an object.
struct Spot {
  double x, y, z, size;
};

// A scene of one camera and kObjects objects, each turned at random. `choose` draws the spots: in
// statements of its own, since the arguments of a call may be evaluated in any order.
template <typename Choose>
Scene Filled(const char* name, std::uint64_t seed, const Camera& camera,
             const std::vector<Plane>& planes, Choose choose) {
  Random random(seed);
  Scene scene;
  scene.name = name;
  scene.cameras = {{"main", camera}};
  for (const Plane& plane : planes) scene.planes.push_back({"", plane});
  for (int i = 0; i < kObjects; ++i) {
    const Spot spot = choose(random);
    const double roll = random.Between(0, 6), pitch = random.Between(0, 6),
                 yaw = random.Between(0, 6);
    SceneObject& object = scene.objects.emplace_back();
    object.box = {{-1.7f, -1.7f, -0.7f}, {1.7f, 1.7f, 0.7f}};
    object.world = Multiply(harness::Scaling(spot.size), harness::Rotation(yaw, pitch, roll));
    const double place[3] = {spot.x, spot.y, spot.z};
    std::copy(place, place + 3, object.world.m[3]);
  }
  return scene;
}

// Objects on hilly ground, seen in the mirror of a lake: the mirror's eye is below the water.
Scene Water() {
  Camera camera;
  camera.far = 500, camera.eye[1] = -4, camera.pitch = -0.15;
  return Filled("water", 3, camera, {{0, 1, 0, 0}}, [](Random& random) -> Spot {
    const double x = random.Between(-200, 200), z = random.Between(0, 400),
                 size = random.Magnitude(0.3, 4);
    return {x, 6 * std::sin(0.03 * x) + 6 * std::cos(0.04 * z) + 3 + 0.8 * size, z, size};
  });
}

// A room behind a door: four planes through the eye and the door's edges, and the door itself.
Scene Portal() {
  Camera camera;
  camera.far = 200;
  const std::vector<Plane> planes = {
      {8, 0, 1.5, 0}, {-8, 0, 1.5, 0}, {0, 8, 2.2, 0}, {0, -8, 2.2, 0}, {0, 0, 1, -8}};
  return Filled("portal", 4, camera, planes, [](Random& random) -> Spot {
    const double size = random.Between(0.2, 1), z = random.Between(8, 88),
                 y = random.Between(-10, 10), x = random.Between(-30, 30);
    return {x, y, z, size};
  });
}

// An engine with a corner of it cut away by three planes.
Scene CutAway() {
  Camera camera;
  camera.far = 60, camera.eye[1] = 3, camera.eye[2] = -14, camera.pitch = 0.2;
  const std::vector<Plane> planes = {{1, 0, 0, 0.2}, {0, 0, 1, 1}, {0, -1, 0, 3}};
  return Filled("cut-away", 5, camera, planes, [](Random& random) -> Spot {
    const double r = 5 * std::sqrt(random.Unit()), a = random.Between(0, 2 * std::numbers::pi);
    const double size = random.Magnitude(0.04, 0.3), y = random.Between(-5, 5);
    return {r * std::cos(a), y, r * std::sin(a), size};
  });
}

// One slice of a cascade of shadow maps, seen from the sun: an orthographic picture with six
// planes.
Scene Cascade() {
  Camera camera;
  camera.orthographic = true, camera.half_height = 60, camera.aspect = 1;
  camera.near = 0.5, camera.far = 400;
  camera.pitch = 1.1, camera.eye[1] = 150, camera.eye[2] = -20;
  const std::vector<Plane> planes = {{1, 0, 0.4, 0},   {-1, 0, 0.4, 0}, {0, 1, 0.3, 0},
                                     {0, -1, 0.3, 10}, {0, 0, 1, -20},  {0, 0, -1, 60}};
  Scene scene = Filled("cascade", 6, camera, planes, [](Random& random) -> Spot {
    const double size = random.Magnitude(0.3, 3), z = random.Between(0, 300),
                 y = random.Between(-2, 12), x = random.Between(-150, 150);
    return {x, y, z, size};
  });
  scene.picture_height = 2048;
  return scene;
}

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

std::vector<Scene> BuiltInScenes() { return {Water(), Portal(), CutAway(), Cascade()}; }

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
  double worst = -1;
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    if ((needed >> i & 1) == 0) continue;
    const auto plane = ViewPlaneFromWorld(scene.planes[i].plane, view);
    const double length = NormalLength(plane.value.plane);
    if (!plane.ok() || !(length > 0) || std::fabs(plane.value.plane.w) / length <= worst) continue;
    worst = std::fabs(plane.value.plane.w) / length;
    facts.view_plane = plane.value.plane;
  }
  if (worst < 0) return facts;
  // The visible part of the cut inside the object's box; the object's middle where there is none.
  const Matrix world_view = Multiply(object.world, view);
  const double farthest = camera.infinite ? depth + size : std::min(camera.far, depth + size);
  std::vector<Vector> cut = CutOfBox(
      VisibleCut(camera, facts.view_plane, camera.near, std::max(farthest, 2 * camera.near)),
      object.box, world_view);
  if (cut.empty()) cut.push_back({in_view[0], in_view[1], depth});
  facts.reach = FarthestReach(camera, cut, OriginInView(world_view));
  facts.world_reach = FarthestReach(camera, cut, OriginInView(view));
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
