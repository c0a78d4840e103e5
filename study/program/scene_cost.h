// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "study/program/studio.h"
#include "study/scene.h"

namespace clipc::study {

// The planes that objects are drawn with.
enum class Planes {
  kNone,  // nothing is clipped
  kAll,   // every plane clips every object
  // Objects that a plane takes away are left out. The others are clipped by the planes that may cut
  // them, and drawn in the order of the number of planes, so that each shader variant is bound
  // once.
  kNeeded,
  kTooFew,  // as kNeeded, without the first needed plane: the image must differ
};

// Draws what a scene's first camera sees, with plane space `object`, a shader variant for each
// number of planes, and the plans of runtime::PlanBox. An OpenGL context of the compatibility
// profile must be current.
class SceneDrawer {
 public:
  SceneDrawer(int width, int height);

  struct Drawn {
    std::vector<std::uint8_t> rgba;
    double cpu_ms = 0;           // of the process, planning included
    long draws = 0, planes = 0;  // draw calls; planes of all of them together
  };
  Drawn Draw(const Scene& scene, Planes planes);

 private:
  Studio studio_;
  std::vector<std::unique_ptr<DrawCall>> variants_;  // [k] has k planes
};

}  // namespace clipc::study
