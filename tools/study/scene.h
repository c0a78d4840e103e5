// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/box_planner.h"
#include "tools/study/advice.h"

namespace clipc::study {

struct SceneObject {
  std::string name;
  runtime::Box box;  // of its own space
  Matrix world;
  bool rigid = true;  // Means::rigid
};

struct NamedCamera {
  std::string name;
  Camera camera;
};

struct NamedPlane {
  std::string name;
  Plane plane;  // in world space; a point on the negative side of any plane is clipped
};

// A scene for the study; it has at most 6 planes.
struct Scene {
  std::string name;
  double picture_height = 1080;
  double tolerance = 0.5;  // pixels that an edge may be displaced by
  Means means;
  std::vector<NamedCamera> cameras;
  std::vector<NamedPlane> planes;
  std::vector<SceneObject> objects;
};

// Water, portal, cut-away and shadow cascade, in this order, with 1000 objects each; the same in
// every run.
std::vector<Scene> BuiltInScenes();

struct ObjectPlan {
  bool outside_frustum = false;  // the object is not drawn
  bool culled = false;           // the object is not drawn: one plane takes away all of it
  std::uint8_t needed = 0;       // bit i: plane i may cut it
};

// Plans one object; leaving out what the plan leaves out changes no pixel, as with
// runtime::PlanBox. Box and planes are compared in the object's own space.
ObjectPlan PlanObject(const SceneObject& object, const Camera& camera,
                      const std::vector<NamedPlane>& planes);

// The facts that Advise needs about drawing that object with the planes `needed`, a bit for each.
// The plane farthest from the eye decides.
DrawFacts FactsOf(const SceneObject& object, const Camera& camera, const Scene& scene,
                  std::uint8_t needed);

}  // namespace clipc::study
