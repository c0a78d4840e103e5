// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/study/scene.h"

namespace clipc::study {

// Scenes to hold the advice against, which is made without them: perspective and orthographic,
// reversed, infinite and off-centre; with one plane or two, with objects that are small, large,
// stretched, mirrored, moved by the shader, or baked into world coordinates; near the world's
// origin or far from it; on machines of every kind; for tolerances of 0.01 to 1 pixel. Equal seeds
// give equal scenes.
std::vector<Scene> RandomScenes(int count, std::uint64_t seed);

// Costs that are as different as they are on some machine.
CostTable CostsOfSomeMachine();

// How the advice on scenes holds against measurements of its own edges.
struct ScenesHeld {
  int advised = 0;     // objects that a plane cuts
  int meets = 0;       // of which a way is said to meet the tolerance
  int misses = 0;      // and does not
  int overlooked = 0;  // no way is said to meet it, and one does with a margin of two
  int dearer = 0;      // one that is cheaper than the advised one meets it with a margin of two
  std::vector<std::string> wrong;  // each miss and each way overlooked, in words
};
ScenesHeld HoldScenes(const std::vector<Scene>& scenes, long edges);

}  // namespace clipc::study
