// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The images that d3d9_main.cpp drew on a real IDirect3DDevice9, against OpenGL's clip distances.
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/harness/offscreen.h"
#include "tools/scenes/comparison.h"
#include "tools/scenes/gl_drawing.h"

namespace clipc::scenes {
namespace {

class Direct3D9 : public ::testing::Test {
 protected:
  static Comparison CompareWithClipDistances(const std::string& name, int plane_count) {
    const std::string path = std::string(CLIPC_D3D9_IMAGES) + "/" + name + ".rgba";
    std::ifstream file(path, std::ios::binary);
    const std::vector<std::uint8_t> image{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(image.size(), std::size_t{4} * kSize * kSize) << path;
    const Scene scene = MakeScene(plane_count);
    const Comparison comparison =
        Compare(DrawScene(Lowering::kClipDistance, scene).rgba, image, DrawCuts(scene).rgba);
    std::printf("Direct3D 9, %s: %d pixels at cuts, of which %d differ; %d differ elsewhere\n",
                name.c_str(), comparison.cut_pixels, comparison.differ_at_cut,
                comparison.differ_elsewhere);
    return comparison;
  }

  const harness::OpenGl context_{harness::Api::kCompatibility};
};
using Seed001Remarks = Direct3D9;

TEST_F(Direct3D9, OnePlaneCutsAsClipDistancesDo) {
  EXPECT_TRUE(Agree(CompareWithClipDistances("1-none", 1), CutError(MakeScene(1))));
}

TEST_F(Direct3D9, ThreePlanesCutAsClipDistancesDo) {
  EXPECT_TRUE(Agree(CompareWithClipDistances("3-none", 3), CutError(MakeScene(3))));
}

// The loops of this shader are unrolled by fxc under level 9; with a wrong index, every object
// would lie elsewhere.
TEST_F(Direct3D9, UnrolledLoopsAreCutAsClipDistancesDo) {
  EXPECT_TRUE(Agree(CompareWithClipDistances("skinned", 3), CutError(MakeScene(3))));
}

TEST_F(Direct3D9, EveryMistakeIsSeen) {
  for (const Mistake mistake : kMistakes) {
    const std::string image = std::string("3-") + NameOf(mistake);
    EXPECT_FALSE(Agree(CompareWithClipDistances(image, 3), CutError(MakeScene(3)))) << image;
  }
}

// With the fixed function the device takes the planes in world space: here with no mathematics of
// ours.
TEST_F(Seed001Remarks, TheFixedFunctionTakesPlanesInWorldSpace) {
  EXPECT_TRUE(Agree(CompareWithClipDistances("fixed-function", 3), CutError(MakeScene(3))));
}

// With a vertex shader the device takes the planes in clip space: the same planes in world space
// are a mistake then.
TEST_F(Seed001Remarks, AVertexShaderTakesPlanesInClipSpace) {
  EXPECT_TRUE(Agree(CompareWithClipDistances("3-none", 3), CutError(MakeScene(3))));
  EXPECT_GT(CompareWithClipDistances("3-space", 3).differ_elsewhere, 1000);
}

}  // namespace
}  // namespace clipc::scenes
