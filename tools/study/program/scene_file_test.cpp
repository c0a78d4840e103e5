// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/study/program/scene_file.h"

#include <cstdio>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/harness/offscreen.h"
#include "tools/study/program/commands.h"

namespace clipc::study {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kHarbour[] = "tools/study/scenes/harbour.json";

std::string TextOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// What ReadScene says of harbour.json with `from` replaced by `to`.
std::string ErrorWith(const std::string& from, const std::string& to) {
  std::string text = TextOf(kHarbour);
  EXPECT_NE(text.find(from), text.npos) << from;
  text.replace(text.find(from), from.size(), to);
  const std::string path = ::testing::TempDir() + "clipc_scene.json";
  std::ofstream(path) << text;
  try {
    ReadScene(path);
  } catch (const harness::DrawError& error) {
    return error.what();
  }
  return "";
}

TEST(SceneFile, Reads) {
  const Scene scene = ReadScene(kHarbour);
  EXPECT_EQ(scene.name, "harbour");
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].camera.near, 0.05);
  EXPECT_EQ(scene.cameras[0].camera.eye[1], -20);
  ASSERT_EQ(scene.objects.size(), 5u);
  EXPECT_FALSE(scene.objects[1].rigid);
  EXPECT_EQ(scene.objects[0].world.m[3][2], 120);
  EXPECT_LT(scene.objects[0].box.low[0], -5);  // outwards
  EXPECT_GT(scene.objects[0].box.high[2], 20);
}

TEST(SceneFile, MistakesAreNamed) {
  EXPECT_THAT(ErrorWith("\"version\": 1", "\"version\": 2"), HasSubstr("`version` is not 1"));
  EXPECT_THAT(ErrorWith("\"planes\"", "\"plains\""), HasSubstr("`planes` is no array"));
  EXPECT_THAT(ErrorWith("\"tolerance\"", "\"tolerence\""),
              HasSubstr("`tolerence` is not known here"));
  EXPECT_THAT(ErrorWith("\"far\": 5000", "\"far\": 0.01"),
              HasSubstr("`cameras[0].far` is no farther than `near`"));
  EXPECT_THAT(ErrorWith("[0, 1, 0, 0]", "[0, 1, 0]"),
              HasSubstr("`planes[0].plane` is no array of 4 numbers"));
  EXPECT_THAT(ErrorWith("[-5, -2, -20]", "[-5, 20, -20]"),
              HasSubstr("`objects[0].low` lies above `high`"));
  EXPECT_THAT(ErrorWith("{", "("), HasSubstr("is no JSON"));
  EXPECT_THROW(ReadScene("tools/study/scenes/none.json"), harness::DrawError);
}

TEST(SceneCommand, SaysWhatEachObjectNeeds) {
  const std::string list = ::testing::TempDir() + "clipc_variants.cmake";
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(
      RunScene({"scene", kHarbour, "--costs", "tools/study/scenes/costs.csv", "--variants", list}),
      0);
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_THAT(text, ContainsRegex("ship +yes +water +object"));
  EXPECT_THAT(text, ContainsRegex("flag +yes +water +xyw1"));  // the shader moves it
  EXPECT_THAT(text, ContainsRegex("lighthouse +yes +none"));
  EXPECT_THAT(text, ContainsRegex("wreck +clipped away"));
  EXPECT_THAT(text, ContainsRegex("behind +not in view"));
  EXPECT_THAT(text, HasSubstr("build: object with 0 to 1 planes"));
  const std::string variants = TextOf(list);
  EXPECT_THAT(variants, HasSubstr("set(CLIPC_SCENE_xyw1_OPTIONS --plane-space=xyw1)"));
  EXPECT_THAT(variants, HasSubstr("set(CLIPC_SCENE_object_VARIANTS 1)"));
  EXPECT_THAT(variants, HasSubstr("set(CLIPC_SCENE_METHODS \"object;xyw1\")"));
  EXPECT_THAT(variants, Not(HasSubstr("discard")));
}

TEST(SceneCommand, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(RunScene({"scene"}), harness::DrawError);
  EXPECT_THROW(RunScene({"scene", kHarbour, "--cost", "x"}), harness::DrawError);
  EXPECT_THROW(RunScene({"scene", kHarbour, "--costs", kHarbour}), harness::DrawError);
}

}  // namespace
}  // namespace clipc::study
