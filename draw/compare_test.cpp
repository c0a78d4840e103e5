// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "draw/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "draw/memory.h"
#include "ir/packing.h"

// The comparison itself: right GLSL passes for every way of lowering, and GLSL with one mistake in it does not.
namespace clipc::draw {
namespace {

using passes::Lowering;

constexpr char kShader[] = R"(
cbuffer Planes { float4 water; float4 portals[2]; };
row_major float3x4 world;
float4x4 view_projection;
uint flags;
struct Output { float4 position : SV_Position; int2 id : ID; float3 color : COLOR; };
[clipplanes(portals[1], water)]
Output main(float4 position : POSITION, int2 id : ID) {
  Output result;
  result.position = mul(float4(mul(world, position), 1), view_projection);
  result.id = id * 3;
  result.color = flags > 2 ? position.xyz : position.zyx;
  return result;
})";

class Compare : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    path_ = std::filesystem::temp_directory_path() / ("compare_test." + std::to_string(getpid()) + ".hlsl");
    std::ofstream(path_) << kShader;
  }
  static void TearDownTestSuite() { std::filesystem::remove(path_); }

  static BuildOptions Options(const std::string& target, Lowering lowering, passes::ClipSpaceOptions clip_space = {}) {
    BuildOptions options;
    options.path = path_;
    options.target = target;
    options.lowering = lowering;
    options.clip_space = clip_space;
    return options;
  }

  // `change` is `from`, a slash and `to`: what to do to the GLSL before it runs.
  static Comparison Run(const BuildOptions& options, const std::string& change = "") {
    static Device device;
    Shader shader = Build(options);
    if (!change.empty()) {
      const std::size_t slash = change.find('/');
      const std::size_t at = shader.glsl.find(change.substr(0, slash));
      EXPECT_NE(at, shader.glsl.npos) << change << "\n" << shader.glsl;
      if (at != shader.glsl.npos) shader.glsl.replace(at, slash, change.substr(slash + 1));
    }
    const RandomOptions draw{.seed = 5, .vertices = 40};
    const RandomInputs inputs = MakeRandomInputs(shader.typed, draw);
    return CompareWithOpenGl(device, shader, MakeExpected(shader, options, inputs), inputs, draw, {});
  }

  static inline std::string path_;
};

TEST_F(Compare, RightShadersPass) {
  for (const char* target : {"glsl460", "glsl410", "glsl330", "glsl140", "glsl130", "essl300", "essl320", "vulkan"}) {
    for (const Lowering lowering : {Lowering::kClipDistance, Lowering::kLevel9, Lowering::kNone}) {
      for (const bool depth : {false, true}) {
        for (const bool flip : {false, true}) {
          const Comparison found = Run(Options(target, lowering, {depth, flip}));
          EXPECT_EQ(found.wrong, 0) << target << found.mistakes.at(0);
          const int distances = lowering == Lowering::kClipDistance ? 2 : 0;
          EXPECT_GE(found.values, 40 * (4 + 2 + 3 + distances)) << target;
          EXPECT_LT(found.worst, 8) << target;
        }
      }
    }
  }
}

TEST_F(Compare, MistakesInDistancesAreSeen) {
  const BuildOptions options = Options("glsl450", Lowering::kClipDistance, {.negative_one_to_one = true, .flip_y = true});
  ASSERT_EQ(Run(options).wrong, 0);
  EXPECT_GT(Run(options, "= dot(/= -dot(").wrong, 0) << "sign";
  EXPECT_GT(Run(options, "portals[1])/portals[0])").wrong, 0) << "plane";
  EXPECT_GT(Run(options, "gl_ClipDistance[0] =/gl_ClipDistance[1] =").wrong, 0) << "index";
  EXPECT_GT(Run(options, "gl_ClipDistance[0] =/gl_Position.y = -gl_Position.y; gl_ClipDistance[0] =").wrong, 0) << "space";
}

TEST_F(Compare, MistakesElsewhereAreSeen) {
  const BuildOptions options = Options("glsl450", Lowering::kNone, {.negative_one_to_one = true, .flip_y = true});
  ASSERT_EQ(Run(options).wrong, 0);
  EXPECT_GT(Run(options, "= -gl_Position.y/= gl_Position.y").wrong, 0) << "flip";
  EXPECT_GT(Run(options, "2.0 */1.999 *").wrong, 0) << "depth range";
  EXPECT_GT(Run(options, " * 3/ * 4").wrong, 0) << "an int";
}

TEST_F(Compare, WrongNumbersOfDistancesAreSeen) {
  const BuildOptions options = Options("glsl450", Lowering::kClipDistance);
  EXPECT_GT(Run(options, "gl_ClipDistance[2];/gl_ClipDistance[3];").wrong, 0);
}

TEST(RandomInputs, DependOnTheSeedOnly) {
  ir::Program program;
  ir::Var var;
  var.name = "p";
  var.type = program.types.Vector(ir::Scalar::kFloat, 4);
  var.storage = ir::Storage::kInput;
  program.inputs.push_back({.var = program.vars.Add(var), .semantic = "POSITION"});
  const auto values = [&](std::uint32_t seed) { return MakeRandomInputs(program, {.seed = seed}).vertices; };
  EXPECT_EQ(values(1), values(1));
  EXPECT_NE(values(1), values(2));
  EXPECT_EQ(values(1).size(), 64u);
}

// Where a component lies, from Microsoft's packing rules.
TEST(Memory, ComponentsInTheOrderOfTheValue) {
  ir::TypeTable types;
  const auto bytes_of = [&](ir::TypeId type, bool row_major) {
    std::vector<std::uint32_t> bytes;
    ForEachComponent(types, type, row_major, 32, [&](ir::Scalar, std::uint32_t byte) { bytes.push_back(byte); });
    return bytes;
  };
  using ::testing::ElementsAre;
  const ir::TypeId float2x3 = types.Matrix(ir::Scalar::kFloat, 2, 3);
  EXPECT_THAT(bytes_of(types.Vector(ir::Scalar::kInt, 3), false), ElementsAre(32, 36, 40));
  EXPECT_THAT(bytes_of(float2x3, false), ElementsAre(32, 48, 64, 36, 52, 68));
  EXPECT_THAT(bytes_of(float2x3, true), ElementsAre(32, 36, 40, 48, 52, 56));
  EXPECT_THAT(bytes_of(types.Array(types.Make(ir::Scalar::kFloat), 3), false), ElementsAre(32, 48, 64));
  ir::Struct inner;
  for (const int components : {3, 2}) {
    ir::Field& field = inner.fields.emplace_back();
    field.type = types.Vector(ir::Scalar::kFloat, components);
  }
  EXPECT_THAT(bytes_of(types.Of(types.AddStruct(inner)), false), ElementsAre(32, 36, 40, 48, 52));
}

}  // namespace
}  // namespace clipc::draw
