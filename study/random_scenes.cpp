// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/random_scenes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "study/scene_measure.h"
#include "study/way.h"

namespace clipc::study {
namespace {

bool OneOf(Random& random, std::uint32_t n) { return random.Below(n) == 0; }

Camera AnyCamera(Random& random) {
  Camera camera;
  camera.near = random.Magnitude(0.002, 2);
  camera.far = camera.near * random.Magnitude(300, 1e6);
  camera.fov = random.Between(15, 100);
  camera.orthographic = OneOf(random, 4);
  camera.reversed = OneOf(random, 3);
  camera.infinite = !camera.orthographic && OneOf(random, 4);
  camera.yaw = random.Between(-3, 3), camera.pitch = random.Between(-1.2, 1.2);
  camera.roll = random.Between(-0.5, 0.5);
  if (OneOf(random, 5))
    camera.offset_x = random.Between(-2, 2), camera.offset_y = random.Between(-2, 2);
  const double away = OneOf(random, 2) ? 0 : random.Magnitude(10, 1e5);
  const Vector there = away * random.Direction();
  camera.eye[0] = there.x, camera.eye[1] = there.y, camera.eye[2] = there.z;
  return camera;
}

// A place in the middle of the picture at that depth, in the world.
Vector PlaceAt(const Camera& camera, double depth, Random& random) {
  const double w = camera.orthographic ? 1 : depth;
  const Matrix p = camera.Projection();
  const double x = random.Between(-0.6, 0.6) - camera.offset_x,
               y = random.Between(-0.6, 0.6) - camera.offset_y;
  const double in_view[4] = {x * w / p.m[0][0], y * w / p.m[1][1], depth, 1};
  const Matrix to_world = camera.ViewToWorld();
  double place[3] = {};
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 4; ++i) place[j] += in_view[i] * to_world.m[i][j];
  }
  return {place[0], place[1], place[2]};
}

void SetBox(SceneObject& object, const double (&middle)[3], double half) {
  for (int axis = 0; axis < 3; ++axis) {
    object.box.low[axis] = static_cast<float>(middle[axis] - half);
    object.box.high[axis] = static_cast<float>(middle[axis] + half);
  }
}

// An object of about that size around a place.
SceneObject AnyObject(Vector place, double size, Random& random) {
  SceneObject object;
  const double at[3] = {place.x, place.y, place.z};
  object.rigid = !OneOf(random, 4);
  const std::uint32_t kind = random.Below(6);
  if (kind == 0) {  // baked: its vertices are the world's
    SetBox(object, at, size);
    return object;
  }
  object.world = harness::Rotation(random.Between(-3, 3), random.Between(-3, 3), random.Unit());
  double middle[3] = {};
  if (kind == 1) {  // a part of a mesh that is elsewhere
    const Vector away = size * random.Magnitude(3, 300) * random.Direction();
    middle[0] = away.x, middle[1] = away.y, middle[2] = away.z;
  }
  double scale[3] = {1, 1, 1};
  if (kind == 2) {
    for (double& axis : scale) axis = random.Magnitude(0.05, 20);
  }
  if (kind == 3) scale[0] = -1;
  SetBox(object, middle, size);
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) object.world.m[i][j] *= scale[i];
  }
  for (int j = 0; j < 3; ++j) {
    object.world.m[3][j] = at[j];
    for (int i = 0; i < 3; ++i) object.world.m[3][j] -= middle[i] * object.world.m[i][j];
  }
  return object;
}

Scene OneScene(Random& random) {
  Scene scene;
  scene.tolerance = random.Magnitude(0.01, 1);
  scene.means.one_matrix = !OneOf(random, 4);
  scene.means.clip_distances = !OneOf(random, 5);
  scene.means.user_planes = OneOf(random, 5);
  scene.means.can_discard = !OneOf(random, 3);
  Camera camera = AnyCamera(random);
  const double depth =
      camera.near * random.Magnitude(5, std::min(1e4, camera.far / camera.near / 4));
  camera.half_height = depth / random.Magnitude(0.3, 1000);
  scene.cameras = {{"main", camera}};
  const int planes = OneOf(random, 3) ? 2 : 1;
  std::vector<Vector> places;
  for (int i = 0; i < planes; ++i) {
    const Vector place = PlaceAt(camera, depth, random), normal = random.Direction();
    const double length = OneOf(random, 4) ? random.Magnitude(1e-3, 1e3) : 1;
    places.push_back(place);
    scene.planes.push_back(
        {"plane " + std::to_string(i),
         {length * normal.x, length * normal.y, length * normal.z, -length * Dot(normal, place)}});
  }
  const double height = camera.HalfHeightAt(depth);
  for (int i = 0; i < 5; ++i) {
    const double size =
        height * (OneOf(random, 5) ? random.Magnitude(2, 30) : random.Magnitude(0.05, 1));
    // Near a plane, mostly.
    const Vector middle = places[random.Below(static_cast<std::uint32_t>(planes))];
    SceneObject object =
        AnyObject(middle + 0.7 * size * random.Unit() * random.Direction(), size, random);
    object.name = "object " + std::to_string(i);
    scene.objects.push_back(object);
  }
  return scene;
}

// Holds the advice on an object against the real errors of the ways that the machine has.
void HoldObject(const Scene& scene, const SceneObject& object, const ObjectAdvice& advised,
                long edges, ScenesHeld& held) {
  const Camera& camera = scene.cameras.front().camera;
  const std::uint8_t needed = advised.plan.needed;
  const auto loses_at_most = [&](const std::string& way, double pixels) {
    const auto lost = MeasureObject(scene, camera, object, needed, WayNamed(way), edges, 99);
    return lost && *lost <= pixels;
  };
  const auto say = [&](const char* what, const Advice& advice) {
    held.wrong.push_back(scene.name + ", " + object.name + ": " + advice.way + what);
  };
  const Advice& best = *advised.best;
  ++held.advised, held.meets += best.meets;
  if (best.meets && !loses_at_most(best.way, scene.tolerance)) {
    ++held.misses;
    say(" misses the tolerance", best);
  }
  const DrawFacts facts = FactsOf(object, camera, scene, needed);
  for (const Advice& other : Advise(facts, CostsOfSomeMachine(), scene.tolerance)) {
    if (!other.possible) continue;
    if (best.meets && other.cost * (1 + kSameCost) >= best.cost) continue;
    if (!loses_at_most(other.way, scene.tolerance / 2)) continue;
    if (best.meets) {
      ++held.dearer;
    } else {
      ++held.overlooked;
      say(" is overlooked", other);
    }
    break;
  }
}

}  // namespace

std::vector<Scene> RandomScenes(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Scene> scenes;
  for (int i = 0; i < count; ++i) {
    scenes.push_back(OneScene(random));
    scenes.back().name = "scene " + std::to_string(i);
  }
  return scenes;
}

CostTable CostsOfSomeMachine() {
  CostTable costs;
  for (const int planes : {1, 3, 6}) {
    for (const char* way : {"clip", "xyw1", "object", "level9", "near-plane"})
      costs[{way, planes}] = 1;
    costs[{"world", planes}] = 1.2, costs[{"cpu", planes}] = 1.6;
    for (const char* way : {"discard", "discard-object"}) costs[{way, planes}] = 1.4;
    costs[{"discard-world", planes}] = 2;
  }
  return costs;
}

ScenesHeld HoldScenes(const std::vector<Scene>& scenes, long edges) {
  ScenesHeld held;
  for (const Scene& scene : scenes) {
    const std::vector<ObjectAdvice> advice =
        AdviseScene(scene, scene.cameras.front().camera, CostsOfSomeMachine());
    for (std::size_t i = 0; i < advice.size(); ++i) {
      if (advice[i].best) HoldObject(scene, scene.objects[i], advice[i], edges, held);
    }
  }
  return held;
}

}  // namespace clipc::study
