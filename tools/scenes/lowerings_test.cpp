// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// One scene through every lowering: the same image. d3d9_test.cpp adds Direct3D 9.
#include <cstdio>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "tools/harness/offscreen.h"
#include "tools/scenes/comparison.h"
#include "tools/scenes/gl_drawing.h"

namespace clipc::scenes {
namespace {

class Lowerings : public ::testing::Test {
 protected:
  // Compares the image of a lowering with that of clip distances without a mistake.
  static Comparison CompareWithClipDistances(Lowering way, int plane_count, Mistake mistake) {
    const Scene scene = MakeScene(plane_count);
    const harness::Image image = DrawScene(way, scene, mistake), cuts = DrawCuts(scene);
    if (const char* folder = std::getenv("CLIPC_IMAGES"); folder != nullptr) {  // to look at them
      const std::string planes = folder + std::string("/") + std::to_string(plane_count);
      WritePng(planes + "-" + NameOf(way) + "-" + NameOf(mistake) + ".png", image);
      WritePng(planes + "-cuts.png", cuts);
    }
    const Comparison comparison =
        Compare(DrawScene(Lowering::kClipDistance, scene).rgba, image.rgba, cuts.rgba);
    std::printf(
        "%s, %d planes, mistake %s: %d pixels at cuts, of which %d differ; %d differ elsewhere\n",
        NameOf(way), plane_count, NameOf(mistake), comparison.cut_pixels, comparison.differ_at_cut,
        comparison.differ_elsewhere);
    return comparison;
  }

  const harness::OpenGl context_{harness::Api::kCompatibility};
};

// Were the cuts everywhere, every image would agree with every other.
TEST_F(Lowerings, TheCutsAreASmallPartOfTheImage) {
  for (const int plane_count : {1, 3}) {
    const Comparison comparison =
        CompareWithClipDistances(Lowering::kClipDistance, plane_count, Mistake::kNone);
    EXPECT_GT(comparison.cut_pixels, 100);
    EXPECT_LT(comparison.cut_pixels, kSize * kSize / 10);
    EXPECT_EQ(comparison.differ_at_cut + comparison.differ_elsewhere, 0) << "the same draw twice";
  }
}

TEST_F(Lowerings, OnePlaneCutsTheSameEveryWay) {
  for (const Lowering way : {Lowering::kLevel9, Lowering::kDiscard, Lowering::kNearPlane}) {
    EXPECT_TRUE(Agree(CompareWithClipDistances(way, 1, Mistake::kNone), CutError(MakeScene(1))))
        << NameOf(way);
  }
}

TEST_F(Lowerings, ThreePlanesCutTheSameEveryWay) {
  for (const Lowering way : {Lowering::kLevel9, Lowering::kDiscard}) {
    EXPECT_TRUE(Agree(CompareWithClipDistances(way, 3, Mistake::kNone), CutError(MakeScene(3))))
        << NameOf(way);
  }
}

// Loops that fxc unrolls under level 9 stay loops in GLSL.
TEST_F(Lowerings, LoopsDrawWhatTheirIterationsDraw) {
  const Scene scene = MakeScene(3);
  EXPECT_EQ(DrawSkinned(scene).rgba, DrawScene(Lowering::kLevel9, scene).rgba);
}

// The comparison is worth something only if it sees what may go wrong.
TEST_F(Lowerings, EveryMistakeIsSeenWithThreePlanes) {
  for (const Lowering way : {Lowering::kClipDistance, Lowering::kLevel9, Lowering::kDiscard}) {
    for (const Mistake mistake : kMistakes) {
      if (mistake == Mistake::kMask && way == Lowering::kDiscard) continue;  // its mask is always 0
      if (mistake == Mistake::kOffset && way != Lowering::kLevel9)
        continue;  // the shader has its planes by name
      EXPECT_FALSE(Agree(CompareWithClipDistances(way, 3, mistake), CutError(MakeScene(3))))
          << NameOf(way) << ' ' << NameOf(mistake);
    }
  }
}

TEST_F(Lowerings, EveryMistakeIsSeenWithOnePlane) {
  for (const Lowering way :
       {Lowering::kClipDistance, Lowering::kLevel9, Lowering::kDiscard, Lowering::kNearPlane}) {
    for (const Mistake mistake : {Mistake::kSign, Mistake::kSpace, Mistake::kIndex}) {
      EXPECT_FALSE(Agree(CompareWithClipDistances(way, 1, mistake), CutError(MakeScene(1))))
          << NameOf(way) << ' ' << NameOf(mistake);
    }
  }
}

}  // namespace
}  // namespace clipc::scenes
