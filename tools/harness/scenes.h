// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "runtime/box_planner.h"
#include "runtime/matrix.h"
#include "tools/harness/camera.h"

namespace clipc::harness {

struct SceneObject {
  runtime::Box box;  // in the object's own space
  Matrix world;
};

// What one camera sees of objects that clip planes cut.
struct Scene {
  std::string name;
  Camera camera;
  // In world space; a point on the negative side of any plane is clipped.
  std::vector<runtime::Plane> planes;
  std::vector<SceneObject> objects;
};

// The scenes water, portal, cut-away and shadow cascade, in this order, with 1000 objects each; the
// same in every run.
std::vector<Scene> BuiltInScenes();

}  // namespace clipc::harness
