// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tools/reference-compiler/compare.h"

// The comparison with a reference compiler itself: it sees what is not the same, and a known bug
// excuses that bug only.
namespace clipc::draw::reference_compiler {
namespace {

constexpr char kShader[] = R"(
struct Light { float3 place; float2 range; };
cbuffer Scene { row_major float3x4 world; Light lights[2]; int count; float4 color; };
struct Item { float4 size; float weight; };
StructuredBuffer<Item> items;
Texture2D map;
SamplerState smooth;
struct Output {
  float4 position : SV_Position;
  float2 uv[2] : TEXCOORD3;
  row_major float3x2 frame : FRAME;
  int kind : KIND;
};
Output main(float4 p : POSITION, float2 uv[2] : TEXCOORD1, uint id : SV_VertexID, int kind : KIND) {
  Output result;
  result.position = float4(mul(world, p), 1) * items[id].weight + map.SampleLevel(smooth, p.xy, 0);
  result.uv[0] = uv[1] * lights[1].range;
  result.uv[1] = uv[0] + color.zw;
  result.frame = float3x2(p.xy, p.yz, lights[0].place.xy);
  result.kind = kind * count;
  return result;
}
)";

class ReferenceCompiler : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    path_ = std::filesystem::temp_directory_path() /
            ("reference_compiler_test." + std::to_string(getpid()) + ".hlsl");
  }
  static void TearDownTestSuite() { std::filesystem::remove(path_); }

  void SetUp() override {
    if (const std::string why = vulkan::Runner::WhyNone(); !why.empty()) GTEST_SKIP() << why;
  }

  static BuildOptions Options() {
    BuildOptions options;
    options.path = path_;
    options.target = "vulkan";
    options.lowering = Lowering::kNone;
    return options;
  }

  static ReferenceComparison Compare(const Shader& shader, const BuildOptions& options,
                                     std::uint32_t seed) {
    static const vulkan::Runner runner;
    return CompareWithGlslang(runner, shader, options, {.seed = seed, .vertices = 40}, {});
  }

  // Compares an entry point of a file beside this one, in the repository's root.
  static ReferenceComparison RunFile(const char* file, const char* entry,
                                     const char* define = "NONE", std::uint32_t seed = 1) {
    BuildOptions options = Options();
    options.path = std::string("tools/reference-compiler/") + file;
    options.entry = entry;
    options.profile = "vs_6_1";
    options.defines = {define};
    return Compare(Build(options), options, seed);
  }

  // The reference compiler reads the text with `from` replaced.
  static ReferenceComparison Run(const std::string& from = "", const std::string& to = "") {
    std::string text = kShader;
    std::ofstream(path_) << text;
    const Shader shader = Build(Options());
    if (!from.empty()) {
      const std::size_t at = text.find(from);
      EXPECT_NE(at, text.npos) << from;
      std::ofstream(path_) << text.replace(at, from.size(), to);
    }
    return Compare(shader, Options(), 3);
  }

  static inline std::string path_;
};

TEST_F(ReferenceCompiler, AgreesOnWhatHasNoBug) {
  const ReferenceComparison found = Run();
  EXPECT_EQ(found.values.wrong, 0) << found.values.mistakes.at(0);
  EXPECT_EQ(found.values.values, 40 * (4 + 4 + 6 + 1));
  EXPECT_THAT(found.known_bugs, ::testing::IsEmpty());
}

// docs/reference-compilers.md describes these bugs.
TEST_F(ReferenceCompiler, KnownBugsAreNamed) {
  const std::pair<const char*, const char*> bugs[] = {{"clipped", "clip-planes"},
                                                      {"remainders", "float-remainder"},
                                                      {"lights", "lit"},
                                                      {"products", "matrix-product"},
                                                      {"initial", "global-initializer"},
                                                      {"unsized", "unsized-initializer"},
                                                      {"views", "system-values"},
                                                      {"columns", "matrix-signature"}};
  for (const auto& [entry, bug] : bugs) {
    const ReferenceComparison found = RunFile("known_bugs.hlsl", entry, "NONE", 2);
    EXPECT_THAT(found.known_bugs, ::testing::ElementsAre(bug)) << entry;
    EXPECT_EQ(found.values.wrong, 0) << entry;
  }
}

TEST_F(ReferenceCompiler, ConstantsMoveToWhereTheReferenceCompilerReadsThem) {
  for (const char* entry : {"elements", "parameters", "packed", "globals", "placed"}) {
    const ReferenceComparison found = RunFile("known_bugs.hlsl", entry, "PLACES");
    EXPECT_EQ(found.values.wrong, 0) << entry;
    EXPECT_GT(found.values.values, 10) << entry;
    EXPECT_THAT(found.known_bugs, ::testing::IsEmpty()) << entry;
  }
}

TEST_F(ReferenceCompiler, AnEffectFileIsReadWithoutItsEffects) {
  const ReferenceComparison found = RunFile("effect.hlsl", "RenderVS");
  EXPECT_EQ(found.values.wrong, 0);
  EXPECT_EQ(found.values.values, 40 * 7);
}

TEST_F(ReferenceCompiler, InvalidSpirvIsNoAnswer) {
  EXPECT_THAT([] { RunFile("known_bugs.hlsl", "scales", "SCALES"); },
              ::testing::ThrowsMessage<DrawError>(
                  ::testing::HasSubstr("glslang makes invalid SPIR-V: GLSL.std.450 Ldexp")));
}

TEST_F(ReferenceCompiler, OtherValuesAreSeen) {
  EXPECT_GT(Run("uv[1] * lights", "uv[0] * lights").values.wrong, 0) << "an element of an input";
  EXPECT_GT(Run("lights[1].range", "lights[0].range").values.wrong, 0)
      << "an element of a constant";
  EXPECT_GT(Run("mul(world, p)", "mul(p.xyz, world).xyz").values.wrong, 0) << "a matrix";
  EXPECT_GT(Run("p.xy, p.yz", "p.yz, p.xy").values.wrong, 0) << "a row of an output";
  EXPECT_GT(Run("color.zw", "color.xy").values.wrong, 0) << "components";
  EXPECT_GT(Run("kind * count", "kind * count + 1").values.wrong, 0) << "an int";
  EXPECT_GT(Run("items[id]", "items[id + 1]").values.wrong, 0) << "an element of a buffer";
  EXPECT_GT(Run("map.SampleLevel(smooth, p.xy", "map.SampleLevel(smooth, p.yx").values.wrong, 0)
      << "a texture's coordinate";
}

TEST_F(ReferenceCompiler, OtherSemanticsAreSeen) {
  EXPECT_GT(Run("KIND;\n}", "SORT;\n}").values.wrong, 0) << "an output";
  EXPECT_GT(Run("TEXCOORD3", "TEXCOORD5").values.wrong, 0) << "its number";
  EXPECT_THROW(Run(" uv[2] : TEXCOORD1,", " uv[2] : TEXCOORD2,"), DrawError) << "an input";
}

}  // namespace
}  // namespace clipc::draw::reference_compiler
