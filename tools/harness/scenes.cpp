// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/harness/scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "tools/harness/random.h"

namespace clipc::harness {
namespace {

constexpr int kObjects = 1000;

// The place and the size of an object.
struct Spot {
  double x, y, z, size;
};

// A scene of one camera and kObjects objects, each turned at random. `choose` draws the spots: in
// statements of its own, since the arguments of a call may be evaluated in any order.
template <typename Choose>
Scene Filled(const char* name, std::uint64_t seed, const Camera& camera,
             const std::vector<runtime::Plane>& planes, Choose choose) {
  Random random(seed);
  Scene scene;
  scene.name = name;
  scene.camera = camera;
  scene.planes = planes;
  for (int i = 0; i < kObjects; ++i) {
    const Spot spot = choose(random);
    const double roll = random.Between(0, 6), pitch = random.Between(0, 6),
                 yaw = random.Between(0, 6);
    SceneObject& object = scene.objects.emplace_back();
    object.box = {{-1.7f, -1.7f, -0.7f}, {1.7f, 1.7f, 0.7f}};
    object.world = Multiply(Scaling(spot.size), Rotation(yaw, pitch, roll));
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
  const std::vector<runtime::Plane> planes = {
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
  const std::vector<runtime::Plane> planes = {{1, 0, 0, 0.2}, {0, 0, 1, 1}, {0, -1, 0, 3}};
  return Filled("cut-away", 5, camera, planes, [](Random& random) -> Spot {
    const double r = 5 * std::sqrt(random.Unit()), a = random.Between(0, 2 * std::numbers::pi);
    const double size = random.Magnitude(0.04, 0.3), y = random.Between(-5, 5);
    return {r * std::cos(a), y, r * std::sin(a), size};
  });
}

// One slice of a cascade of shadow maps, seen from the sun: an orthographic image with six
// planes.
Scene Cascade() {
  Camera camera;
  camera.orthographic = true, camera.half_height = 60, camera.aspect = 1;
  camera.near = 0.5, camera.far = 400;
  camera.pitch = 1.1, camera.eye[1] = 150, camera.eye[2] = -20;
  const std::vector<runtime::Plane> planes = {{1, 0, 0.4, 0},   {-1, 0, 0.4, 0}, {0, 1, 0.3, 0},
                                              {0, -1, 0.3, 10}, {0, 0, 1, -20},  {0, 0, -1, 60}};
  return Filled("cascade", 6, camera, planes, [](Random& random) -> Spot {
    const double size = random.Magnitude(0.3, 3), z = random.Between(0, 300),
                 y = random.Between(-2, 12), x = random.Between(-150, 150);
    return {x, y, z, size};
  });
}

}  // namespace

std::vector<Scene> BuiltInScenes() { return {Water(), Portal(), CutAway(), Cascade()}; }

}  // namespace clipc::harness
