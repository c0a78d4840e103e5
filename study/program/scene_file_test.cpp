// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/scene_file.h"

#include <cstdio>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "study/program/commands.h"
#include "study/program/speed.h"
#include "tools/harness/offscreen.h"

namespace clipc::study {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kHarbour[] = "study/scenes/harbour.json";

std::string TextOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// The error of ReadScene for harbour.json, or another file, with `from` replaced by `to`.
std::string ErrorWith(const std::string& from, const std::string& to,
                      const std::string& file = kHarbour) {
  std::string text = TextOf(file);
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

TEST(SceneFile, ReadsEveryOption) {
  const std::string path = ::testing::TempDir() + "clipc_options.json";
  std::ofstream(path) << R"({"schema": "clipc.study-scene", "version": 1, "picture_height": 720,
    "tolerance": 0.25, "clip_distances": false, "user_planes": true, "can_discard": false,
    "one_matrix": false, "cameras": [{"reversed": true, "infinite": true, "offset": [2, 3]},
      {"orthographic": true, "half_height": 7, "aspect": 2, "yaw": 1, "pitch": 2, "roll": 3}],
    "planes": [{"plane": [1, 2, 3, 4]}], "objects": [{"low": [0, 0, 0], "high": [1, 1, 1]}]})";
  const Scene scene = ReadScene(path);
  EXPECT_EQ(scene.image_height, 720);
  EXPECT_EQ(scene.tolerance, 0.25);
  EXPECT_FALSE(scene.means.clip_distances || scene.means.can_discard);
  EXPECT_EQ(scene.means.order, runtime::MatrixOrder::kWorldFirst);
  EXPECT_TRUE(scene.means.user_planes);
  const Camera &first = scene.cameras[0].camera, &second = scene.cameras[1].camera;
  EXPECT_TRUE(first.reversed && first.infinite && !first.orthographic);
  EXPECT_EQ(first.offset_x, 2);
  EXPECT_EQ(first.offset_y, 3);
  EXPECT_TRUE(second.orthographic && !second.reversed && !second.infinite);
  EXPECT_EQ(second.half_height, 7);
  EXPECT_EQ(second.yaw + 10 * second.pitch + 100 * second.roll, 321);
  EXPECT_EQ(scene.planes[0].plane.w, 4);
  EXPECT_TRUE(scene.objects[0].rigid);
}

TEST(SceneFile, MistakesAreNamed) {
  EXPECT_THAT(ErrorWith("\"version\": 1", "\"version\": 2"), HasSubstr("`version` is not 1"));
  EXPECT_THAT(ErrorWith("\"planes\"", "\"plains\""), HasSubstr("`planes` is not an array"));
  EXPECT_THAT(ErrorWith("\"tolerance\"", "\"tolerence\""),
              HasSubstr("`tolerence` is not known here"));
  EXPECT_THAT(ErrorWith("\"tolerance\"", "\"one_matrix\": \"double\", \"tolerance\""),
              HasSubstr("`one_matrix` is neither true, false, \"world-view\", "));
  EXPECT_THAT(ErrorWith("\"far\": 5000", "\"far\": 0.01"),
              HasSubstr("`cameras[0].far` is not farther than `near`"));
  EXPECT_THAT(ErrorWith("\"tolerance\": 0.5", "\"tolerance\": 0"),
              HasSubstr("`tolerance` is not positive"));
  EXPECT_THAT(ErrorWith("\"fov\": 60", "\"fov\": 180"),
              HasSubstr("`cameras[0].fov` is 180 degrees or more"));
  EXPECT_THAT(ErrorWith("\"fov\": 60", "\"orthographic\": true, \"infinite\": true"),
              HasSubstr("`cameras[0].infinite` is for perspectives"));
  std::string planes = "[";
  for (int i = 0; i < 7; ++i) planes += R"({"plane": [0, 1, 0, 0]}, )";
  EXPECT_THAT(ErrorWith("[{ \"name\": \"water\"", planes + "{ \"name\": \"water\""),
              HasSubstr("`planes` has more than 6 elements"));
  EXPECT_THAT(ErrorWith("[0, 1, 0, 0]", "[0, 1, 0]"),
              HasSubstr("`planes[0].plane` is not an array of 4 numbers"));
  EXPECT_THAT(ErrorWith("[-5, -2, -20]", "[-5, 20, -20]"),
              HasSubstr("`objects[0].low` lies above `high`"));
  EXPECT_THAT(ErrorWith("120, 1]", "120, 2]"),
              HasSubstr("`objects[0].world` is not a world matrix: elements 3, 7, 11 and 15 are "));
  EXPECT_THAT(ErrorWith("120, 1]", "1e300, 1]"),
              HasSubstr("`objects[0].world` has 1e+300; lengths are at most 1e+12"));
  EXPECT_THAT(ErrorWith("[5, 12, 20]", "[5, 12, 1e39]"),
              HasSubstr("`objects[0].high` has 1e+39; lengths are at most 1e+12"));
  EXPECT_THAT(ErrorWith("[0, -20, 0]", "[1e300, -20, 0]"),
              HasSubstr("`cameras[0].eye` has 1e+300; lengths are at most 1e+12"));
  const std::string gltf = "study/scenes/harbour.gltf";
  EXPECT_THAT(ErrorWith("[0, -20, 0]", "[1e300, -20, 0]", gltf),
              HasSubstr("`mirrored` has 1e+300; lengths are at most 1e+12"));
  EXPECT_THAT(ErrorWith("[0, 0, -120]", "[0, 0, 1e13]", gltf),
              HasSubstr("has -1e+13; lengths are at most 1e+12"));
  EXPECT_THAT(ErrorWith("{", "("), HasSubstr("is not JSON"));
  EXPECT_THROW(ReadScene("study/scenes/none.json"), harness::DrawError);
}

TEST(SceneCommand, SaysWhatEachObjectNeeds) {
  const std::string list = ::testing::TempDir() + "clipc_variants.cmake",
                    json = ::testing::TempDir() + "clipc_harbour.json";
  std::remove(list.c_str()), std::remove(json.c_str());
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(RunScene({"scene", kHarbour, "--costs", "study/scenes/costs.csv", "--variants", list,
                      "--json", json}),
            0);
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_THAT(text, ContainsRegex("ship +yes +water +object"));
  EXPECT_THAT(text, ContainsRegex("flag +yes +water +xyw1"));  // the shader moves it
  EXPECT_THAT(text, HasSubstr("\n  clipc ship.hlsl --plane-space=object --variants=1\n"));
  EXPECT_THAT(text, HasSubstr("\n  clipc flag.hlsl --plane-space=xyw1 --variants=1\n"));
  EXPECT_THAT(text, Not(HasSubstr("clipc lighthouse.hlsl")));
  EXPECT_THAT(text, ContainsRegex("lighthouse +yes +none +any +0 +0 +yes +1.000"));
  EXPECT_THAT(text, ContainsRegex("wreck +clipped away *\n"));
  const nlohmann::json images = nlohmann::json::parse(TextOf(json));
  for (const auto& object : images[0]["objects"])
    EXPECT_EQ(object.contains("planes"), object["drawn"] == "yes") << object["object"];
  EXPECT_THAT(text, ContainsRegex("behind +not in view"));
  EXPECT_THAT(text, HasSubstr("build: object with up to 1 plane"));
  const std::string variants = TextOf(list);
  EXPECT_THAT(variants, HasSubstr("set(CLIPC_SCENE_xyw1_OPTIONS --plane-space=xyw1)"));
  EXPECT_THAT(variants, HasSubstr("set(CLIPC_SCENE_object_VARIANTS 1)"));
  EXPECT_THAT(variants, HasSubstr("set(CLIPC_SCENE_METHODS \"object;xyw1\")"));
  EXPECT_THAT(variants, Not(HasSubstr("discard")));
}

// The exit code and the outputs of RunScene for a scene of one plane and some objects.
struct Said {
  int exit_code;
  std::string text, variants;
  nlohmann::json images;
};
Said SayFor(const std::string& options, const std::string& plane, const std::string& objects,
            const std::string& eye = "[0, 0, 0]") {
  // Tests run side by side.
  const std::string path = ::testing::TempDir() + "clipc_" +
                           ::testing::UnitTest::GetInstance()->current_test_info()->name(),
                    scene = path + ".scene.json", json = path + ".advice.json",
                    list = path + ".variants.cmake";
  std::remove(json.c_str()), std::remove(list.c_str());
  std::ofstream(scene) << R"({"schema": "clipc.study-scene", "version": 1, )" << options
                       << R"("cameras": [{"near": 0.1, "far": 10000, "eye": )" << eye
                       << R"(}], "planes": [{"name": "the cut", "plane": )" << plane
                       << R"(}], "objects": [)" << objects << "]}";
  ::testing::internal::CaptureStdout();
  Said said;
  said.exit_code = RunScene(
      {"scene", scene, "--costs", "study/scenes/speed.csv", "--json", json, "--variants", list});
  said.variants = TextOf(list);
  said.text = ::testing::internal::GetCapturedStdout();
  said.images = nlohmann::json::parse(TextOf(json));
  return said;
}
constexpr char kBox[] = R"({"name": "old ship", "low": [-3, -3, -3], "high": [3, 3, 3],
  "world": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 100, 1]})";
constexpr char kMoved[] = R"({"name": "flag", "rigid": false, "low": [-3, -3, -3],
  "high": [3, 3, 3], "world": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 100, 1]})";
constexpr char kCut[] = "[0.6, 0, 0.8, -80]";

TEST(SceneCommand, SaysWhatMeetsTheTolerance) {
  const Said said = SayFor("", kCut, kBox);
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_THAT(said.text, HasSubstr("tolerance 0.5 pixels in the image"));
  EXPECT_THAT(said.text,
              ContainsRegex("\"old ship\" +yes +\"the cut\" +object +[0-9.e-]+ +[0-9.e-]+ +yes"));
  const auto& object = said.images[0]["objects"][0];
  EXPECT_EQ(object["object"], "old ship");
  EXPECT_EQ(object["planes"][0], "the cut");
  EXPECT_EQ(object["method"], "object");
  EXPECT_EQ(object["cost"], ReadCosts("study/scenes/speed.csv").at({"object", 1}));
  EXPECT_EQ(object["meets"], true);
  EXPECT_LT(object["pixels_off"], 0.5);
}

// The second plane cuts the first of two objects only; a variant has the most planes of any.
TEST(SceneCommand, NamesAllPlanesOfAnObject) {
  const std::string second = std::string(kCut) + R"(}, {"name": "b", "plane": [0, 1, 0, 0])";
  std::string above = kBox;
  above.replace(above.find("0, 0, 100"), 9, "0, 9, 100");
  const Said said = SayFor("", second, std::string(kBox) + "," + above);
  EXPECT_THAT(said.text, ContainsRegex("\"old ship\" +yes +\"the cut.b\" +object"));
  EXPECT_EQ(said.images[0]["objects"][0]["planes"].size(), 2u);
  EXPECT_EQ(said.images[0]["objects"][1]["planes"].size(), 1u);
  EXPECT_THAT(said.text, HasSubstr("the cut+b"));
  EXPECT_THAT(said.text, HasSubstr("build: object with up to 2 planes"));
}

TEST(SceneCommand, SaysThatNothingMeetsTheTolerance) {
  const Said said = SayFor(R"("tolerance": 0.0001, "can_discard": false, )", kCut, kMoved);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.text,
              ContainsRegex("flag +yes +\"the cut\" +world +0\\.[0-9]+ +0\\.[0-9]+ +no"));
  EXPECT_THAT(said.text, HasSubstr("\n1 object without a method that keeps the tolerance"));
  EXPECT_EQ(said.images[0]["objects"][0]["meets"], false);
}

// The repository's small table of costs lacks `world`, the way that keeps the tolerance here.
TEST(SceneCommand, SaysThatTheCostIsUnknown) {
  const std::string json = ::testing::TempDir() + "clipc_unknown_cost.json";
  const std::string scene = ::testing::TempDir() + "clipc_unknown_cost.scene.json";
  std::string text = TextOf("study/scenes/near_and_far_plane.json");
  text.replace(text.find("0.3"), 3, "1.5");
  text.replace(text.find("\"low\""), 5, "\"rigid\": false, \"low\"");
  std::ofstream(scene) << text;
  ::testing::internal::CaptureStdout();
  const int exit_code =
      RunScene({"scene", scene, "--costs", "study/scenes/costs.csv", "--json", json});
  const std::string said = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(exit_code, 0) << said;
  EXPECT_THAT(said, HasSubstr("unknown\n  the table of costs does not have `world`\n"));
  const auto object = nlohmann::json::parse(TextOf(json))[0]["objects"][0];
  EXPECT_TRUE(object["cost"].is_null());
  EXPECT_EQ(object["meets"], true);
}

TEST(SceneCommand, NamesTheCure) {
  const std::string baked = R"({"name": "level", "low": [49997, 49997, 49997],
    "high": [50003, 50003, 50003]})";
  EXPECT_THAT(
      SayFor(R"("tolerance": 0.1, )", "[0.6, 0, 0.8, -70000]", baked, "[50000, 50000, 49990]").text,
      HasSubstr("give the mesh one of its own"));
  const std::string far_away = R"("can_discard": false, "one_matrix": false, )";
  const std::string moved = R"({"name": "flag", "rigid": false, "low": [-3, -3, -3],
    "high": [3, 3, 3], "world": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 8e5, 0, 100, 1]})";
  const Said said = SayFor(far_away, "[0.6, 0, 0.8, -480080]", moved, "[8e5, 0, 0]");
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.text, HasSubstr("multiply its matrices in double"));
  EXPECT_EQ(SayFor("", kCut, kBox).images[0]["objects"][0].contains("cure"), false);
}

TEST(SceneCommand, GoesOnAfterAnImpossibleObject) {
  const Said said = SayFor(R"("clip_distances": false, "can_discard": false, )", kCut,
                           std::string(kBox) + "," + kMoved + "," + kBox);
  EXPECT_EQ(said.exit_code, 1);
  const auto& objects = said.images[0]["objects"];
  EXPECT_EQ(objects[0]["method"], "cpu");
  EXPECT_TRUE(objects[1]["method"].is_null());
  EXPECT_EQ(objects[2]["method"], "cpu");
  EXPECT_THAT(said.text, ContainsRegex("flag +yes +\"the cut\" +none +- +- +no"));
  // No shader is built for an object that no method can clip, nor by clipc for the processor.
  EXPECT_THAT(said.text, HasSubstr("\nbuild: cpu with up to 1 plane\n1 object without"));
  EXPECT_THAT(said.text, Not(ContainsRegex("build: [^c]")));
  EXPECT_THAT(said.variants, HasSubstr("set(CLIPC_SCENE_METHODS \"\")"));
}

TEST(SceneCommand, SaysThatAPlaneIsRefused) {
  const Said said = SayFor("", "[6e-32, 0, 8e-32, -8e-30]", kBox);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.text, HasSubstr("refused: the cut: "));
  EXPECT_THAT(said.text, Not(HasSubstr("any")));
  EXPECT_FALSE(said.images[0]["objects"][0].contains("planes"));
}

// What the study measures along the object is not what one sees where the object's own vertices are
// displaced: far from the world's origin.
TEST(SceneCommand, JudgesInTheImageOrAlongTheObject) {
  const std::string far_away = R"({"name": "rock", "low": [-2, -2, -2], "high": [2, 2, 2],
    "world": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10000, -7000, 3010, 1]})";
  const auto of = [&](const std::string& judged_in) {
    return SayFor(R"("one_matrix": false, "tolerance": 0.05, "can_discard": false, )" + judged_in,
                  "[0.48, 0.36, 0.8, -4688]", far_away, "[10000, -7000, 3000]");
  };
  const Said image = of(""), surface = of(R"("judged_in": "surface", )");
  EXPECT_EQ(image.exit_code, 1);
  EXPECT_EQ(surface.exit_code, 0);
  EXPECT_THAT(surface.text, HasSubstr("tolerance 0.05 pixels along the object"));
  EXPECT_THAT(image.text, HasSubstr("multiply its matrices in double"));
  const auto seen = image.images[0]["objects"][0], along = surface.images[0]["objects"][0];
  EXPECT_EQ(along["method"], "object");
  EXPECT_LT(along["pixels_along_object"], 0.001);
  EXPECT_GT(along["pixels_in_image"], 0.2);
  EXPECT_EQ(along["pixels_off"], along["pixels_along_object"]);
  EXPECT_EQ(seen["pixels_off"], seen["pixels_in_image"]);
}

// A tide line across one mesh of a whole country: `object` multiplies its height by one number, and
// loses nothing along it.
TEST(SceneCommand, CutsAlongAnAxisOfABakedMeshAreExactAlongIt) {
  const std::string country = R"({"name": "country", "low": [19900, -10, 29900],
    "high": [20100, 90, 30100]})";
  const Said said =
      SayFor(R"("judged_in": "surface", )", "[0, 1, 0, -0.3]", country, "[20000, 20, 29800]");
  const auto object = said.images[0]["objects"][0];
  EXPECT_EQ(object["method"], "object");
  EXPECT_LT(object["pixels_along_object"], 1e-4);
  EXPECT_GT(object["pixels_in_image"], 0.01);
}

// The portal removes the part of the tide line that is next to the eye.
TEST(SceneCommand, WhatAnotherPlaneRemovesDoesNotCount) {
  const std::string json = ::testing::TempDir() + "clipc_portal.json";
  ::testing::internal::CaptureStdout();
  const int exit_code = RunScene({"scene", "study/scenes/portal_hides_the_near_cut.json", "--costs",
                                  "study/scenes/speed.csv", "--json", json});
  ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(exit_code, 0);
  const auto object = nlohmann::json::parse(TextOf(json))[0]["objects"][0];
  EXPECT_EQ(object["planes"].size(), 2u);
  EXPECT_LT(object["pixels_off"], 0.02);  // 0.0042 by __float128
}

// The floor is cut next to the eye and the wall far away: a way that is good enough for the wall,
// which is farther from the eye, is not for the floor.
TEST(SceneCommand, AsksEachPlaneByItself) {
  const std::string json = ::testing::TempDir() + "clipc_near_and_far.json";
  ::testing::internal::CaptureStdout();
  const int exit_code = RunScene({"scene", "study/scenes/near_and_far_plane.json", "--costs",
                                  "study/scenes/speed.csv", "--json", json});
  ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(exit_code, 1);
  const auto object = nlohmann::json::parse(TextOf(json))[0]["objects"][0];
  EXPECT_EQ(object["planes"].size(), 2u);
  EXPECT_EQ(object["meets"], false);  // `object` loses 0.44 pixels of the floor, of 0.3
  EXPECT_GT(object["pixels_off"], 0.44);
}

TEST(SceneCommand, Helps) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(RunScene({"scene", "--help"}), 0);
  EXPECT_THAT(::testing::internal::GetCapturedStdout(), HasSubstr("clipc-study scene FILE"));
}

// Two tables of one run differ by chance; the advice does not.
TEST(SceneCommand, RecommendationsAreThoseOfTheSecondTable) {
  const CostTable first = ReadCosts("study/scenes/speed.csv"),
                  second = ReadCosts("study/scenes/speed-again.csv");
  int differs = 0, advised = 0;
  for (const Scene& scene : BuiltInScenes()) {
    const Camera& camera = scene.cameras.front().camera;
    const auto advice = AdviseScene(scene, camera, first),
               again = AdviseScene(scene, camera, second);
    for (std::size_t i = 0; i < advice.size(); ++i) {
      if (!advice[i].best) continue;
      ++advised, differs += advice[i].best->way != again[i].best->way;
    }
  }
  EXPECT_GT(advised, 50);
  EXPECT_EQ(differs, 0);
}

TEST(SceneCommand, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(RunScene({"scene"}), harness::DrawError);
  EXPECT_THROW(RunScene({"scene", kHarbour, "--cost", "x"}), harness::DrawError);
  ::testing::internal::CaptureStdout();
  EXPECT_THROW(RunScene({"scene", kHarbour, "--costs", "study/scenes/costs.csv", "--json",
                         ::testing::TempDir() + "clipc-none/advice.json"}),
               harness::DrawError);
  ::testing::internal::GetCapturedStdout();
  EXPECT_THROW(RunScene({"scene", kHarbour, "--costs", kHarbour}), harness::DrawError);
}

}  // namespace
}  // namespace clipc::study
