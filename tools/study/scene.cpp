// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/study/scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "runtime/clip_plane.h"
#include "tools/study/numbers.h"

namespace clipc::study {
namespace {

using runtime::Matrix;
using runtime::Plane;

// Random numbers are drawn in statements of their own: the arguments of a call may be evaluated in
// any order.
SceneObject ObjectAt(Random& random, double x, double y, double z, double size) {
  SceneObject object;
  object.box = {{-1.7f, -1.7f, -0.7f}, {1.7f, 1.7f, 0.7f}};
  const double third = random.Between(0, 6), second = random.Between(0, 6),
               first = random.Between(0, 6);
  object.world = Rotation(first, second, third);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) object.world.m[i][j] *= size;
  }
  object.world.m[3][0] = x, object.world.m[3][1] = y, object.world.m[3][2] = z;
  return object;
}

constexpr int kObjects = 1000;

// Things on hilly ground, seen in the mirror of a lake: the mirror's eye is below the water.
Scene Water() {
  Random random(3);
  Scene scene;
  scene.name = "water";
  Camera camera;
  camera.far = 500, camera.eye[1] = -4, camera.pitch = -0.15;
  scene.cameras = {{"mirrored", camera}};
  scene.planes = {{"water", {0, 1, 0, 0}}};
  for (int i = 0; i < kObjects; ++i) {
    const double x = random.Between(-200, 200), z = random.Between(0, 400),
                 size = random.Magnitude(0.3, 4);
    scene.objects.push_back(ObjectAt(
        random, x, 6 * std::sin(0.03 * x) + 6 * std::cos(0.04 * z) + 3 + 0.8 * size, z, size));
  }
  return scene;
}

// A room behind a door: four planes through the eye and the door's edges, and the door itself.
Scene Portal() {
  Random random(4);
  Scene scene;
  scene.name = "portal";
  Camera camera;
  camera.far = 200;
  scene.cameras = {{"main", camera}};
  const double sides[5][4] = {
      {8, 0, 1.5, 0}, {-8, 0, 1.5, 0}, {0, 8, 2.2, 0}, {0, -8, 2.2, 0}, {0, 0, 1, -8}};
  const char* const names[] = {"left", "right", "bottom", "top", "door"};
  for (int i = 0; i < 5; ++i)
    scene.planes.push_back({names[i], {sides[i][0], sides[i][1], sides[i][2], sides[i][3]}});
  for (int i = 0; i < kObjects; ++i) {
    const double size = random.Between(0.2, 1), z = random.Between(8, 88),
                 y = random.Between(-10, 10), x = random.Between(-30, 30);
    scene.objects.push_back(ObjectAt(random, x, y, z, size));
  }
  return scene;
}

// An engine with a corner of it cut away by three planes.
Scene CutAway() {
  Random random(5);
  Scene scene;
  scene.name = "cut-away";
  Camera camera;
  camera.far = 60, camera.eye[1] = 3, camera.eye[2] = -14, camera.pitch = 0.2;
  scene.cameras = {{"main", camera}};
  scene.planes = {{"side", {1, 0, 0, 0.2}}, {"front", {0, 0, 1, 1}}, {"top", {0, -1, 0, 3}}};
  for (int i = 0; i < kObjects; ++i) {
    const double r = 5 * std::sqrt(random.Unit()), a = random.Between(0, 2 * std::numbers::pi);
    const double size = random.Magnitude(0.04, 0.3), y = random.Between(-5, 5);
    scene.objects.push_back(ObjectAt(random, r * std::cos(a), y, r * std::sin(a), size));
  }
  return scene;
}

// One slice of a cascade of shadow maps, seen from the sun: an orthographic picture with six
// planes.
Scene Cascade() {
  Random random(6);
  Scene scene;
  scene.name = "cascade";
  scene.picture_height = 2048;
  Camera camera;
  camera.orthographic = true, camera.half_height = 60, camera.aspect = 1, camera.near = 0.5,
  camera.far = 400;
  camera.pitch = 1.1, camera.eye[1] = 150, camera.eye[2] = -20;
  scene.cameras = {{"sun", camera}};
  scene.planes = {{"left", {1, 0, 0.4, 0}},  {"right", {-1, 0, 0.4, 0}},
                  {"below", {0, 1, 0.3, 0}}, {"above", {0, -1, 0.3, 10}},
                  {"near", {0, 0, 1, -20}},  {"far", {0, 0, -1, 60}}};
  for (int i = 0; i < kObjects; ++i) {
    const double size = random.Magnitude(0.3, 3), z = random.Between(0, 300),
                 y = random.Between(-2, 12), x = random.Between(-150, 150);
    scene.objects.push_back(ObjectAt(random, x, y, z, size));
  }
  return scene;
}

// The plane of clip space in the object's own space: rows of the whole matrix times the plane.
// Rounded to float, pushed outwards by what the rounding may have moved it.
runtime::Float4 Outwards(const Plane& plane, double slack) {
  return {static_cast<float>(plane.x), static_cast<float>(plane.y), static_cast<float>(plane.z),
          static_cast<float>(plane.w + slack)};
}

bool IsOutsideFrustum(const SceneObject& object, const Camera& camera) {
  const Matrix m =
      runtime::Multiply(runtime::Multiply(object.world, camera.View()), camera.Projection());
  const Plane sides[] = {{1, 0, 0, 1},  {-1, 0, 0, 1}, {0, 1, 0, 1},
                         {0, -1, 0, 1}, {0, 0, 1, 0},  {0, 0, -1, 1}};
  for (const Plane& side : sides) {
    const Plane plane = runtime::PlaneBefore(m, side);
    double reach = std::fabs(plane.w);
    const double c[3] = {plane.x, plane.y, plane.z};
    for (int i = 0; i < 3; ++i) {
      reach += std::fabs(c[i]) * static_cast<double>(std::max(std::fabs(object.box.low[i]),
                                                              std::fabs(object.box.high[i])));
    }
    const runtime::Float4 outwards = Outwards(plane, 1e-6 * reach);
    if (runtime::PlanBox(object.box, &outwards, 1) == runtime::kCulled) return true;
  }
  return false;
}

}  // namespace

std::vector<Scene> BuiltInScenes() { return {Water(), Portal(), CutAway(), Cascade()}; }

ObjectPlan PlanObject(const SceneObject& object, const Camera& camera,
                      const std::vector<NamedPlane>& planes) {
  ObjectPlan plan;
  plan.outside_frustum = IsOutsideFrustum(object, camera);
  std::vector<runtime::Float4> constants;
  for (const NamedPlane& plane : planes) {
    const auto constant = runtime::ObjectPlaneFromWorld(plane.plane, object.world);
    constants.push_back(constant.ok() ? constant.value.constant : runtime::Float4{});
  }
  const runtime::BoxPlan needed = runtime::PlanBox(object.box, constants.data(), constants.size());
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
  double middle[4] = {0, 0, 0, 1}, in_world[4], in_view[4];
  for (int i = 0; i < 3; ++i)
    middle[i] =
        (static_cast<double>(object.box.low[i]) + static_cast<double>(object.box.high[i])) / 2;
  for (int j = 0; j < 4; ++j) {
    in_world[j] = 0;
    for (int i = 0; i < 4; ++i) in_world[j] += middle[i] * object.world.m[i][j];
  }
  for (int j = 0; j < 4; ++j) {
    in_view[j] = 0;
    for (int i = 0; i < 4; ++i) in_view[j] += in_world[i] * view.m[i][j];
  }
  facts.world_offset =
      std::sqrt(in_world[0] * in_world[0] + in_world[1] * in_world[1] + in_world[2] * in_world[2]);
  facts.depth = std::max(in_view[2], camera.near);
  double diagonal = 0;
  for (int j = 0; j < 3; ++j) {
    double side = 0;
    for (int i = 0; i < 3; ++i) {
      side += (static_cast<double>(object.box.high[i]) - static_cast<double>(object.box.low[i])) *
              std::fabs(object.world.m[i][j]);
    }
    diagonal += side * side;
  }
  facts.extent =
      std::sqrt(diagonal) / (camera.orthographic
                                 ? camera.half_height
                                 : facts.depth * std::tan(camera.fov * std::numbers::pi / 360));
  double worst = -1;
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    if ((needed >> i & 1) == 0) continue;
    const auto plane = runtime::ViewPlaneFromWorld(scene.planes[i].plane, view);
    const double length = runtime::NormalLength(plane.value.plane);
    if (!plane.ok() || !(length > 0) || std::fabs(plane.value.plane.w) / length <= worst) continue;
    worst = std::fabs(plane.value.plane.w) / length;
    facts.view_plane = plane.value.plane;
  }
  return facts;
}

}  // namespace clipc::study
