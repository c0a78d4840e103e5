// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/box_planner.h"
#include "tools/study/advice.h"
#include "tools/study/camera.h"

namespace clipc::study {

struct SceneObject {
  std::string name;
  runtime::Box box;  // of its own space
  runtime::Matrix world;
  bool rigid = true;  // Means::rigid
};

struct NamedCamera {
  std::string name;
  Camera camera;
};

struct NamedPlane {
  std::string name;
  runtime::Plane plane;  // world space; what is behind any of the planes is clipped
};

// At most 6 planes.
struct Scene {
  std::string name;
  double picture_height = 1080;
  double tolerance = 0.5;  // pixels that an edge may be displaced by
  Means means;
  std::vector<NamedCamera> cameras;
  std::vector<NamedPlane> planes;
  std::vector<SceneObject> objects;
};

// Water, portal, cut-away and shadow cascade with 1000 objects each; the same every time.
std::vector<Scene> BuiltInScenes();

struct ObjectPlan {
  bool outside_frustum = false;  // not drawn at all
  bool culled = false;           // nor this: one plane takes all of it
  std::uint8_t needed = 0;       // bit i: plane i may cut it
};

// Safe to the pixel, as runtime::PlanBox is: box and planes are compared in the object's own space.
ObjectPlan PlanObject(const SceneObject& object, const Camera& camera,
                      const std::vector<NamedPlane>& planes);

// What Advise needs to know to draw that object with the planes it needs; the worst of them
// decides.
DrawFacts FactsOf(const SceneObject& object, const Camera& camera, const Scene& scene,
                  std::uint8_t needed);

}  // namespace clipc::study
