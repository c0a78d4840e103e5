// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/gltf_scene.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "study/program/commands.h"
#include "study/program/scene_file.h"
#include "tools/harness/offscreen.h"

namespace clipc::study {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;
using runtime::Matrix;

constexpr char kHarbour[] = "study/scenes/harbour.gltf";

Json Harbour() { return Json::parse(std::ifstream(kHarbour)); }

void ExpectNear(const Matrix& a, const Matrix& b) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(a.m[i][j], b.m[i][j], 1e-12) << i << ' ' << j;
  }
}

std::string ErrorOf(const std::string& bytes) {
  try {
    GltfScene(bytes, "");
  } catch (const harness::DrawError& error) {
    return error.what();
  }
  return "";
}

// The message about harbour.gltf with a value changed.
std::string ErrorWith(const char* pointer, const Json& value) {
  Json json = Harbour();
  json[Json::json_pointer(pointer)] = value;
  return ErrorOf(json.dump());
}

std::string OutputFor(const char* file) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(RunScene({"scene", file, "--costs", "study/scenes/costs.csv"}), 0);
  return ::testing::internal::GetCapturedStdout();
}

// The .glb file of a JSON text and a buffer.
std::string Binary(std::string json, std::string buffer) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
  std::string bytes;
  const auto add = [&](std::size_t number) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> 8 * i & 255);
  };
  bytes += "glTF", add(2), add(28 + json.size() + buffer.size());
  add(json.size()), bytes += "JSON" + json;
  add(buffer.size()), bytes += std::string("BIN\0", 4) + buffer;
  return bytes;
}

TEST(GltfScene, HarbourIsTheOneOfTheJson) {
  const Scene gltf = ReadScene(kHarbour), json = ReadScene("study/scenes/harbour.json");
  ExpectNear(gltf.cameras.at(0).camera.View(), json.cameras.at(0).camera.View());
  ExpectNear(gltf.cameras.at(0).camera.Projection(), json.cameras.at(0).camera.Projection());
  EXPECT_EQ(gltf.planes.at(0).plane.y, 1);
  EXPECT_EQ(OutputFor(kHarbour), OutputFor("study/scenes/harbour.json"));
}

// A camera that is turned about all axes, and a point before it: glTF's own way to clip space,
// column vectors and z from -w to w, against the scene's.
TEST(GltfScene, CamerasSeeWhatTheySaw) {
  const double q[4] = {0.36, -0.48, 0.64, 0.48}, eye[3] = {3, -4, 5};
  Json json = Harbour();
  json["nodes"][0] = {{"camera", 0}, {"translation", eye}, {"rotation", q}, {"scale", {2, 2, 2}}};
  const Camera camera = GltfScene(json.dump(), "").cameras.at(0).camera;
  const auto rotated = [&](const double(&v)[3], double(&to)[3]) {  // q v q*, by the vector formula
    const double s = q[3];
    const double dot = q[0] * v[0] + q[1] * v[1] + q[2] * v[2];
    const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      to[i] = 2 * dot * q[i] + (s * s - square) * v[i] + 2 * s * (q[j] * v[k] - q[k] * v[j]);
    }
  };
  const double local[3] = {0.5, -0.25, -7};  // right of the middle, below it, 7 ahead
  double world[3];
  rotated(local, world);
  for (int i = 0; i < 3; ++i) world[i] += eye[i];
  const Matrix matrix = runtime::Multiply(camera.View(), camera.Projection());
  const double mirrored[4] = {world[0], world[1], -world[2], 1};
  double clip[4] = {0, 0, 0, 0};
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) clip[j] += mirrored[i] * matrix.m[i][j];
  }
  const double f = 1 / std::tan(std::numbers::pi / 6);
  EXPECT_NEAR(clip[3], 7, 1e-12);
  EXPECT_NEAR(clip[0], 0.5 * f * 9 / 16, 1e-12);
  EXPECT_NEAR(clip[1], -0.25 * f, 1e-12);
  EXPECT_NEAR(clip[2], (7 - 0.05) * 5000 / (5000 - 0.05), 1e-9);
}

TEST(GltfScene, Lenses) {
  Json json = Harbour();
  json["cameras"][0]["perspective"] = {{"yfov", 0.5}, {"znear", 0.25}};
  Camera camera = GltfScene(json.dump(), "").cameras.at(0).camera;
  EXPECT_TRUE(camera.infinite);
  EXPECT_NEAR(camera.fov, 28.6479, 1e-4);
  EXPECT_EQ(camera.near, 0.25);

  json["cameras"][0] = {{"type", "orthographic"},
                        {"orthographic", {{"xmag", 4}, {"ymag", 2}, {"znear", 0}, {"zfar", 50}}}};
  camera = GltfScene(json.dump(), "").cameras.at(0).camera;
  EXPECT_TRUE(camera.orthographic);
  EXPECT_EQ(camera.half_height, 2);
  EXPECT_EQ(camera.aspect, 2);
  EXPECT_EQ(camera.far, 50);
  EXPECT_EQ(camera.Projection().m[3][2], 0);
}

// A plane keeps the side that its node's y axis points to, whatever scales and mirrors the nodes
// above it have.
TEST(GltfScene, PlanesFollowTheirNodes) {
  const double h = std::sqrt(0.5);
  Json json = Harbour();
  json["nodes"][1]["rotation"] = {h, 0, 0, h};  // y becomes z
  json["nodes"][1]["translation"] = {1, 2, 3};
  for (const double side : {1.0, -1.0}) {
    json["nodes"][1]["scale"] = {2, 5 * side, 3};
    const runtime::Plane plane = GltfScene(json.dump(), "").planes.at(0).plane;
    EXPECT_NEAR(plane.x, 0, 1e-12);
    EXPECT_NEAR(plane.y, 0, 1e-12);
    EXPECT_NEAR(plane.z, -side, 1e-12);      // mirrored
    EXPECT_NEAR(plane.w, -3 * side, 1e-12);  // z = 3, which is -3 here
  }
}

TEST(GltfScene, MorphedAndSkinnedMeshesAreWhereTheyMayBe) {
  Json json = Harbour();
  json["accessors"].push_back({{"componentType", 5126},
                               {"type", "VEC3"},
                               {"count", 8},
                               {"min", {-1, 2, 0}},
                               {"max", {0, 3, 0}}});
  json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 4}}};
  SceneObject ship = GltfScene(json.dump(), "").objects.at(0);
  EXPECT_FALSE(ship.rigid);
  EXPECT_NEAR(ship.box.low[0], -6, 1e-5);
  EXPECT_NEAR(ship.box.low[1], -2, 1e-5);
  EXPECT_NEAR(ship.box.high[1], 15, 1e-5);

  // Joints: the shore, whose inverse bind matrix moves by 100 along z, and the lighthouse. The
  // node's own place is ignored.
  json = Harbour();
  json["nodes"][2]["skin"] = 0;
  json["skins"] = {{{"joints", {4, 4}}, {"inverseBindMatrices", 4}}};
  json["accessors"].push_back(
      {{"componentType", 5126}, {"type", "MAT4"}, {"count", 2}, {"bufferView", 0}});
  json["bufferViews"] = {{{"buffer", 0}, {"byteLength", 128}}};
  json["buffers"] = {{{"byteLength", 128}}};
  float binds[32] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 100, 1,
                     1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 0, 0,   1};
  std::string buffer(sizeof binds, '\0');
  std::memcpy(buffer.data(), binds, sizeof binds);
  ship = GltfScene(Binary(json.dump(), buffer), "").objects.at(0);
  EXPECT_FALSE(ship.rigid);
  // The shore turns about y: z from 80 to 120 becomes -120 to -80, x from 2 to 12 becomes -12 to
  // -2.
  EXPECT_NEAR(ship.box.low[2], -120, 1e-4);
  EXPECT_NEAR(ship.box.high[2], 20, 1e-4);
  EXPECT_NEAR(ship.box.low[0], -12, 1e-4);
  EXPECT_NEAR(ship.box.high[0], 5, 1e-4);
  EXPECT_EQ(ship.world.m[2][2], -1);
  EXPECT_EQ(ship.world.m[3][2], 0);

  json["accessors"][4]["byteOffset"] = 4;
  EXPECT_THAT(ErrorOf(Binary(json.dump(), buffer)),
              HasSubstr("`skins[0].inverseBindMatrices` ends before the matrix of joint 1"));
}

TEST(GltfScene, MistakesAreNamed) {
  EXPECT_THAT(ErrorWith("/asset/version", "1.0"),
              HasSubstr("`asset.version` is \"1.0\"; only 2.0 is read"));
  EXPECT_THAT(ErrorWith("/scene", 3), HasSubstr("`scene` is 3, of 1"));
  EXPECT_THAT(ErrorWith("/scenes/0/nodes/2", 99), HasSubstr("`scene.nodes[2]` is 99, of 8"));
  EXPECT_THAT(ErrorWith("/nodes/5/children", {4}),
              HasSubstr("`nodes[4]` is reached twice; the nodes of a scene are trees"));
  EXPECT_THAT(ErrorWith("/nodes/4/children", {6, 6}), HasSubstr("`nodes[6]` is reached twice"));
  EXPECT_THAT(ErrorWith("/nodes/0/camera", 7), HasSubstr("`nodes[0].camera` is 7, of 1"));
  EXPECT_THAT(ErrorWith("/nodes/2/mesh", 9), HasSubstr("`nodes[2].mesh` is 9, of 4"));
  EXPECT_THAT(ErrorWith("/nodes/0/rotation", {0, 0, 0, 0}),
              HasSubstr("`nodes[0].rotation` is not a unit quaternion"));
  EXPECT_THAT(ErrorWith("/nodes/0/scale", {1, -1, 1}),
              HasSubstr("`nodes[0]` is a camera whose space is skewed or mirrored"));
  EXPECT_THAT(ErrorWith("/nodes/1/scale", {0, 1, 1}),
              HasSubstr("`nodes[1]` has no plane: its scale is 0"));
  EXPECT_THAT(ErrorWith("/nodes/1/extras/clip_plane", 1),
              HasSubstr("`nodes[1].extras.clip_plane` is neither true nor false"));
  EXPECT_THAT(ErrorWith("/nodes/1/extras", nullptr), HasSubstr("there is no plane to clip by"));
  EXPECT_THAT(ErrorWith("/nodes/6/matrix", {1, 2}),
              HasSubstr("`nodes[6].matrix` is not an array of 16 numbers"));
  EXPECT_THAT(ErrorWith("/nodes/4/scale", {1e308, 1e308, 1e308}),
              HasSubstr("is moved beyond all numbers"));
  EXPECT_THAT(ErrorWith("/scenes/0/extras/judged_in", "object"),
              HasSubstr("`scene.extras.judged_in` is neither \"image\" nor \"surface\""));
  EXPECT_THAT(ErrorWith("/nodes/2/skin", 0), HasSubstr("`nodes[2].skin` is 0, of 0"));
  EXPECT_THAT(ErrorWith("/nodes/2/extensions", {{"EXT_mesh_gpu_instancing", Json::object()}}),
              HasSubstr("draws the mesh in places"));
  EXPECT_THAT(ErrorWith("/accessors/0/min", nullptr),
              HasSubstr("`accessors[0].min` is not an array of 3 numbers"));
  EXPECT_THAT(ErrorWith("/accessors/0/min", {0, 99, 0}),
              HasSubstr("`accessors[0].min` lies above `max`"));
  EXPECT_THAT(ErrorWith("/accessors/0/type", "VEC2"),
              HasSubstr("`accessors[0]` holds positions and is not of float VEC3"));
  EXPECT_THAT(ErrorWith("/meshes/0/primitives/0/attributes/POSITION", 44),
              HasSubstr("`meshes[0].primitives[0].attributes.POSITION` is 44, of 4"));
  EXPECT_THAT(ErrorWith("/cameras/0/perspective/yfov", 4),
              HasSubstr("`cameras[0].perspective.yfov` is not between 0 and pi"));
  EXPECT_THAT(ErrorWith("/cameras/0/perspective/zfar", 0.01),
              HasSubstr("`cameras[0].perspective.zfar` is not farther than `znear`"));
  EXPECT_THAT(ErrorWith("/scenes/0/extras/tolerance", 0),
              HasSubstr("`scene.extras.tolerance` is not a positive number"));
  EXPECT_THAT(ErrorWith("/buffers", {{{"byteLength", 4}, {"uri", "none.bin"}}}),
              HasSubstr("no glTF: "));
  EXPECT_THAT(ErrorOf("{"), HasSubstr("is not JSON"));
  EXPECT_THAT(ErrorOf("glTF"), HasSubstr("within the header"));
}

TEST(GltfScene, DeepFilesAreRefused) {
  Json json = Harbour();
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  std::string text = json.dump();
  text.insert(1, "\"extras\": " + deep + ",");
  EXPECT_THAT(ErrorOf(text), HasSubstr("nested deeper than 64 levels"));
  // A chain of nodes as deep is fine: there is no recursion in it.
  json["nodes"][4].erase("rotation");
  for (int i = 8; i < 20000; ++i) json["nodes"].push_back({{"children", {i + 1}}});
  json["nodes"].push_back(Json::object());
  json["nodes"][7]["children"] = {8};
  EXPECT_EQ(GltfScene(json.dump(), "").objects.size(), 5u);
}

// Damaged files are refused or read, and nothing else happens: whatever byte of a .gltf or .glb is
// overwritten or missing.
TEST(GltfScene, DamagedFilesDoNoHarm) {
  const std::string text = Harbour().dump();
  const std::string binary = Binary(text, std::string(16, '\0'));
  std::uint32_t bits = 2024;
  const auto next = [&](std::size_t limit) {
    bits = bits * 1664525 + 1013904223;
    return (bits >> 8) % limit;
  };
  int refused = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string bytes = i % 2 == 0 ? text : binary;
    const std::size_t changes = 1 + next(3);
    for (std::size_t k = 0; k < changes; ++k) {
      const std::size_t at = next(bytes.size());
      if (next(4) == 0)
        bytes.erase(at, 1 + next(20));
      else
        bytes[at] = "0123456789-,[]{}\":e.\0\xff"[next(22)];
      if (bytes.empty()) bytes = " ";
    }
    refused += !ErrorOf(bytes).empty();
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace clipc::study
