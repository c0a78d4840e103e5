// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/scene_cost.h"

#include <gtest/gtest.h>

#include "tools/harness/offscreen.h"

namespace clipc::study {
namespace {

// The planes that are left out change no pixel; those that are left in do.
TEST(SceneCost, LeavingOutWhatIsNotNeededChangesNoPixel) {
  const harness::OpenGl opengl(harness::Api::kCompatibility);
  SceneDrawer drawer(320, 180);
  for (const Scene& scene : BuiltInScenes()) {
    const auto none = drawer.Draw(scene, Planes::kNone), all = drawer.Draw(scene, Planes::kAll);
    const auto needed = drawer.Draw(scene, Planes::kNeeded),
               too_few = drawer.Draw(scene, Planes::kTooFew);
    EXPECT_TRUE(needed.rgba == all.rgba) << scene.name;
    EXPECT_FALSE(none.rgba == all.rgba) << scene.name;  // the planes are seen
    EXPECT_FALSE(too_few.rgba == all.rgba) << scene.name;
    EXPECT_LT(needed.planes, all.planes / 4) << scene.name;
    EXPECT_LT(needed.draws, all.draws) << scene.name;
  }
}

}  // namespace
}  // namespace clipc::study
