// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The advice held against __float128 on scenes that nobody chose. `clipc-study` does the same with
// 500 of them (advice-scenes.csv).
#include "study/random_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/scene_measure.h"

namespace clipc::study {
namespace {

constexpr long kEdges = 400;

TEST(RandomScenes, AdviceHolds) {
  const ScenesHeld held = HoldScenes(RandomScenes(100, 7), kEdges);
  EXPECT_GT(held.advised, 300);
  EXPECT_GT(held.meets, 250);
  EXPECT_THAT(held.wrong, ::testing::IsEmpty());
  EXPECT_LE(held.dearer, 0.02 * held.advised);
}

// Mutation: laws alone, with room for every plane's luck, overlook ways that meet a tolerance.
TEST(RandomScenes, LawsAloneWouldOverlookWays) {
  int overlooked = 0;
  for (const Scene& scene : RandomScenes(60, 7)) {
    const Camera& camera = scene.cameras.front().camera;
    for (const SceneObject& object : scene.objects) {
      const ObjectPlan plan = PlanObject(object, camera, scene.planes);
      if (!plan.drawn() || plan.needed == 0 || !plan.refused.empty()) continue;
      const DrawFacts facts = FactsOf(object, camera, scene, plan.needed);
      const Advice best = Advise(facts, CostsOfSomeMachine(), scene.tolerance).front();
      if (best.meets || !best.possible) continue;
      const auto measured =
          MeasureObject(scene, camera, object, plan.needed, WayNamed(best.way), kEdges, 99);
      overlooked += measured && *measured <= scene.tolerance / 2;
    }
  }
  EXPECT_GT(overlooked, 0);
}

}  // namespace
}  // namespace clipc::study
