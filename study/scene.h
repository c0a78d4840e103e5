// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runtime/box_planner.h"
#include "study/advice.h"

namespace clipc::study {

struct SceneObject {
  std::string name;
  runtime::Box box;  // in the object's own space
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
  double image_height = 1080;
  double tolerance = 0.5;  // pixels that an edge may be displaced by
  runtime::JudgedIn judged_in = runtime::JudgedIn::kImage;  // what that displacement is
  Means means;
  std::vector<NamedCamera> cameras;
  std::vector<NamedPlane> planes;
  std::vector<SceneObject> objects;
};

// The scenes of tools/harness/scenes.h.
std::vector<Scene> BuiltInScenes();

struct ObjectPlan {
  bool outside_frustum = false;  // the object is not drawn
  bool culled = false;           // the object is not drawn: one plane takes away all of it
  std::uint8_t needed = 0;       // bit i: plane i may cut it
  // The plane that the runtime refuses for the object, and the reason: then nothing is planned.
  // Empty if no plane is refused.
  std::string refused;

  bool drawn() const { return !outside_frustum && !culled; }
};

// Plans one object. Box and planes are compared in the object's own space: drawn with `object`, an
// image without the objects and planes that plans leave out has the same pixels, as with
// runtime::PlanBox. With other ways a plane that is left out may have cut a pixel by its error.
ObjectPlan PlanObject(const SceneObject& object, const Camera& camera,
                      const std::vector<NamedPlane>& planes);

// The way to draw one object of an image.
struct ObjectAdvice {
  ObjectPlan plan;
  // The recommended way: none for an object that is not drawn, needs no plane, or has a plane that
  // is refused.
  std::optional<Advice> best;
  std::string cure;  // CureFor, where `best` is not good enough

  // Whether the request cannot be met: a plane is refused, no way is possible, or none keeps the
  // tolerance.
  bool fails() const { return !plan.refused.empty() || (best && !best->meets); }
};

// The advice on every object for a camera, beside scene.objects. `near-plane` is recommended for
// all that is drawn or for nothing: where each drawn object is cut by the same one plane.
// `progress` is told the share of the objects that are done.
std::vector<ObjectAdvice> AdviseScene(const Scene& scene, const Camera& camera,
                                      const CostTable& costs,
                                      const std::function<void(double)>& progress = {});

// The facts that Advise needs about drawing that object with the planes `needed`, a bit for each.
// Each plane that has a normal, and whose cut the camera sees where the other planes keep it, is
// one of the facts' cuts.
DrawFacts FactsOf(const SceneObject& object, const Camera& camera, const Scene& scene,
                  std::uint8_t needed);

}  // namespace clipc::study
