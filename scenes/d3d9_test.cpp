// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The pictures that d3d9_main.cpp drew on a real IDirect3DDevice9, against OpenGL's clip distances.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scenes/comparison.h"
#include "scenes/gl_drawing.h"

namespace clipc::scenes {
namespace {

class Direct3D9 : public ::testing::Test {
 protected:
  static Comparison CompareWithClipDistances(int plane_count, Mistake mistake) {
    const std::string path =
        std::string(CLIPC_D3D9_PICTURES) + "/" + std::to_string(plane_count) + "-" + NameOf(mistake) + ".rgba";
    std::ifstream file(path, std::ios::binary);
    const std::vector<std::uint8_t> picture{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(picture.size(), std::size_t{4} * kSize * kSize) << path;
    const Scene scene = MakeScene(plane_count);
    const Comparison comparison = Compare(DrawScene(Way::kClipDistance, scene).rgba, picture, DrawCuts(scene).rgba);
    std::printf("Direct3D 9, %d planes, mistake %s: %d pixels at cuts, of which %d differ; %d differ elsewhere\n", plane_count,
                NameOf(mistake), comparison.cut_pixels, comparison.differ_at_cut, comparison.differ_elsewhere);
    return comparison;
  }

  const examples::Context context_{examples::Profile::kCompatibility};
};

TEST_F(Direct3D9, OnePlaneCutsAsClipDistancesDo) {
  EXPECT_TRUE(Agree(CompareWithClipDistances(1, Mistake::kNone), CutError(MakeScene(1))));
}

TEST_F(Direct3D9, ThreePlanesCutAsClipDistancesDo) {
  EXPECT_TRUE(Agree(CompareWithClipDistances(3, Mistake::kNone), CutError(MakeScene(3))));
}

TEST_F(Direct3D9, EveryMistakeIsSeen) {
  for (const Mistake mistake : kMistakes) {
    EXPECT_FALSE(Agree(CompareWithClipDistances(3, mistake), CutError(MakeScene(3)))) << NameOf(mistake);
  }
}

}  // namespace
}  // namespace clipc::scenes
