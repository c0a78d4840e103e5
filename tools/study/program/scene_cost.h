// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tools/study/program/studio.h"
#include "tools/study/scene.h"

namespace clipc::study {

// How many planes objects are drawn with.
enum class Planes {
  kNone,    // nothing is clipped
  kAll,     // every plane on every object
  kNeeded,  // objects that a plane takes away are left out; the others have the planes that may cut
            // them, and are drawn in the order of their number, so that each shader variant is
            // bound once
  kTooFew,  // as kNeeded, without the first needed plane: what must look different
};

// Draws a scene's first camera with plane space `object`: a shader variant for each number of
// planes, the plans of runtime::PlanBox.
class SceneDrawer {
 public:
  SceneDrawer(draw::Device& device, int width, int height);

  struct Drawn {
    std::vector<std::uint8_t> rgba;  // from the bottom row up
    double cpu_ms = 0;               // of the process, planning included
    long draws = 0, planes = 0;      // draw calls; planes of all of them together
  };
  Drawn Draw(const Scene& scene, Planes planes);

 private:
  Studio studio_;
  std::vector<std::unique_ptr<DrawCall>> variants_;  // [k] has k planes
};

}  // namespace clipc::study
