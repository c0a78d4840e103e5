// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/scene.h"

namespace clipc::study {

// Scenes to hold the advice against, which is made without them: perspective and orthographic,
// reversed, infinite and off-centre; with one plane or two, with objects that are small, large,
// stretched, mirrored, moved by the shader, or baked into world coordinates; near the world's
// origin or far from it; on machines of every kind; for tolerances of 0.01 to 1 pixel. Equal seeds
// give equal scenes.
std::vector<Scene> RandomScenes(int count, std::uint64_t seed);

// A table of costs that differ as much as on a real machine.
CostTable CostsOfSomeMachine();

// The agreement of the advice on scenes with measurements of other edges.
struct ScenesHeld {
  int advised = 0;     // objects that a plane cuts
  int meets = 0;       // objects whose best way is said to meet the tolerance
  int misses = 0;      // objects whose best way is said to meet it, and does not
  int overlooked = 0;  // objects without such a way where one meets it by a margin of two
  int dearer = 0;      // objects where a cheaper way than the best meets it by a margin of two
  std::vector<std::string> wrong;  // each miss and each way overlooked, in words
};
ScenesHeld HoldScenes(const std::vector<Scene>& scenes, long edges);

}  // namespace clipc::study
