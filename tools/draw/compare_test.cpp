// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/compare.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "ir/packing.h"
#include "tools/draw/buffers.h"
#include "tools/draw/images.h"
#include "tools/draw/memory.h"
#include "tools/draw/opengl/compare.h"
#include "tools/draw/vulkan/compare.h"

// The comparison itself: right GLSL passes for every way of lowering, and GLSL with one mistake in
// it does not.
namespace clipc::draw {
namespace {

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

constexpr char kObjects[] = R"(
Texture2D colors, others, pages[2];
Texture2D<int> numbers;
Texture2DArray<float> layers;
SamplerState smooth;
SamplerComparisonState nearer;
Buffer<float2> typed;
struct Item { float3 place; int kind; float weight; };
StructuredBuffer<Item> items;
ByteAddressBuffer memory;
struct Output {
  float4 position : SV_Position;
  float4 color : COLOR;
  float4 page : PAGE;
  float4 gathered : GATHERED;
  float4 item : ITEM;
  int4 loaded : LOADED;
  uint4 bytes : BYTES;
  float4 sizes : SIZES;
};
Output main(float4 p : POSITION, uint4 index : INDEX) {
  Output result;
  result.position = p;
  result.color = colors.SampleLevel(smooth, p.xy, 0) + others.SampleLevel(smooth, p.xy, 0) * p.x;
  result.page = pages[1].SampleLevel(smooth, p.xy, 0) + layers.SampleCmpLevelZero(nearer, p.xyz, p.w);
  result.gathered = colors.GatherGreen(smooth, p.xy);
  Item item = items[index.x];
  result.item = float4(item.place, item.weight * typed[index.y].x);
  result.loaded = numbers.Load(int3(index.xy, 0)) * 10 + item.kind;
  result.bytes = memory.Load4(index.z * 4);
  uint width, height;
  colors.GetDimensions(width, height);
  result.sizes = float4(width, height, p.xy);
  return result;
})";

constexpr char kGroup[] = R"(
RWStructuredBuffer<uint> items;
RWTexture2D<float> image;
groupshared uint parts[8];
[numthreads(8, 1, 1)]
void main(uint i : SV_GroupIndex, uint3 id : SV_DispatchThreadID) {
  uint slot = id.x + 24 * id.y;
  parts[i] = items[slot] + 3;
  GroupMemoryBarrierWithGroupSync();
  items[slot] = parts[7 - i];
  image[id.xy] = i * 0.5;
})";

constexpr char kPatch[] = R"(
struct Corner { float4 p : POSITION; };
struct Point { float3 p : POSITION; uint number : NUMBER; };
struct Constants { float edges[3] : SV_TessFactor; float inside : SV_InsideTessFactor; float3 middle : MIDDLE; };
Constants OfPatch(OutputPatch<Point, 3> points, uint id : SV_PrimitiveID) {
  Constants c;
  c.edges[0] = points[0].p.x;
  c.edges[1] = c.edges[2] = id;
  c.inside = 5;
  c.middle = points[0].p + points[1].p;
  return c;
}
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)]
[patchconstantfunc("OfPatch")]
Point main(InputPatch<Corner, 2> patch, uint i : SV_OutputControlPointID) {
  Point p = {patch[0].p.xyz * i + patch[1].p.www, i};
  return p;
})";

class ComparedShaders : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    path = std::filesystem::temp_directory_path() /
           ("compare_test." + std::to_string(getpid()) + ".hlsl");
    std::ofstream(path) << kShader;
    objects_path = path + ".objects.hlsl";
    std::ofstream(objects_path) << kObjects;
    group_path = path + ".group.hlsl";
    std::ofstream(group_path) << kGroup;
    patch_path = path + ".patch.hlsl";
    std::ofstream(patch_path) << kPatch;
  }
  static void TearDownTestSuite() {
    std::filesystem::remove(path);
    std::filesystem::remove(objects_path);
    std::filesystem::remove(group_path);
    std::filesystem::remove(patch_path);
  }

  static BuildOptions Options(const std::string& target, Lowering lowering,
                              passes::ClipSpaceOptions clip_space = {}) {
    BuildOptions options;
    options.path = path;
    options.target = target;
    options.lowering = lowering;
    options.clip_space = clip_space;
    return options;
  }

  // Compares the shader's GLSL, changed before it runs: `change` is `from`, a slash and `to`.
  static Comparison Run(const BuildOptions& options, const std::string& change = "") {
    Shader shader = Build(options);
    if (!change.empty()) {
      const std::size_t slash = change.find('/');
      const std::size_t at = shader.glsl.find(change.substr(0, slash));
      EXPECT_NE(at, shader.glsl.npos) << change << "\n" << shader.glsl;
      if (at != shader.glsl.npos) shader.glsl.replace(at, slash, change.substr(slash + 1));
    }
    const RandomOptions draw{.seed = 5, .vertices = 40};
    const RandomInputs inputs = MakeRandomInputs(shader.typed, draw);
    const std::vector<Expected> expected = MakeExpected(shader, options, inputs);
    if (options.target == "vulkan") {
      static const vulkan::Runner kRunner;
      return vulkan::CompareWithVulkan(kRunner, {shader, expected, inputs, draw, {}});
    }
    static harness::OpenGl opengl;
    return CompareWithOpenGl(opengl, {shader, expected, inputs, draw, {}});
  }

  static BuildOptions Objects(const std::string& target = "glsl450") {
    BuildOptions options = Options(target, Lowering::kNone);
    options.path = objects_path;
    return options;
  }

  static inline std::string path, objects_path, group_path, patch_path;
};

TEST_F(ComparedShaders, RightShadersPass) {
  for (const char* target :
       {"glsl460", "glsl410", "glsl330", "glsl140", "glsl130", "essl300", "essl320", "vulkan"}) {
    if (target == std::string("vulkan") && !vulkan::Runner::WhyNone().empty()) continue;
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

TEST_F(ComparedShaders, MistakesInDistancesAreSeen) {
  const BuildOptions options =
      Options("glsl450", Lowering::kClipDistance, {.negative_one_to_one = true, .flip_y = true});
  ASSERT_EQ(Run(options).wrong, 0);
  EXPECT_GT(Run(options, "= dot(/= -dot(").wrong, 0) << "sign";
  EXPECT_GT(Run(options, "portals[1])/portals[0])").wrong, 0) << "plane";
  EXPECT_GT(Run(options, "gl_ClipDistance[0] =/gl_ClipDistance[1] =").wrong, 0) << "index";
  EXPECT_GT(
      Run(options, "gl_ClipDistance[0] =/gl_Position.y = -gl_Position.y; gl_ClipDistance[0] =")
          .wrong,
      0)
      << "space";
}

TEST_F(ComparedShaders, MistakesElsewhereAreSeen) {
  const BuildOptions options =
      Options("glsl450", Lowering::kNone, {.negative_one_to_one = true, .flip_y = true});
  ASSERT_EQ(Run(options).wrong, 0);
  EXPECT_GT(Run(options, "= -gl_Position.y/= gl_Position.y").wrong, 0) << "flip";
  EXPECT_GT(Run(options, "2.0 */1.999 *").wrong, 0) << "depth range";
  EXPECT_GT(Run(options, " * 3/ * 4").wrong, 0) << "an int";
}

TEST_F(ComparedShaders, WrongNumbersOfDistancesAreSeen) {
  const BuildOptions options = Options("glsl450", Lowering::kClipDistance);
  EXPECT_GT(Run(options, "gl_ClipDistance[2];/gl_ClipDistance[3];").wrong, 0);
}

TEST_F(ComparedShaders, MistakesWithTexturesAreSeen) {
  const BuildOptions options = Objects();
  ASSERT_EQ(Run(options).wrong, 0);
  EXPECT_GT(Run(options, "textureLod(colors/textureLod(others").wrong, 0) << "another texture";
  EXPECT_GT(
      Run(options,
          "textureLod(colors, in_POSITION0.xy, 0.0)/textureLod(colors, in_POSITION0.xy, 0.0).yxzw")
          .wrong,
      0);
  EXPECT_GT(Run(options, "colors, in_POSITION0.xy, 0.0/colors, in_POSITION0.yx, 0.0").wrong, 0)
      << "coordinates";
  EXPECT_GT(Run(options, "colors, in_POSITION0.xy, 0.0/colors, in_POSITION0.xy, 1.0").wrong, 0)
      << "another level";
  EXPECT_GT(Run(options, "vec4(in_POSITION0.xyz/vec4(in_POSITION0.xyx").wrong, 0)
      << "another element of an array texture";
  EXPECT_GT(Run(options,
                "textureGather(colors, in_POSITION0.xy, 1)/textureGather(colors, in_POSITION0.xy, "
                "1).wzyx")
                .wrong,
            0);
  EXPECT_GT(Run(options, "pages[1]/pages[0]").wrong, 0) << "another element";
  EXPECT_GT(Run(options, "in_POSITION0.xy, 1)/in_POSITION0.xy, 2)").wrong, 0)
      << "another component is gathered";
  EXPECT_GT(Run(options, "in_INDEX0.xy/in_INDEX0.yx").wrong, 0) << "another texel is loaded";
  EXPECT_GT(Run(options, "textureSize(colors/textureSize(others").wrong, 0)
      << "the size of another";
  EXPECT_GT(
      Run(options, "in_POSITION0.xyz, in_POSITION0.w/in_POSITION0.xyz, in_POSITION0.w - 0.5").wrong,
      0)
      << "reference";
}

TEST_F(ComparedShaders, MistakesWithBuffersAreSeen) {
  const BuildOptions options = Objects();
  ASSERT_EQ(Run(options).wrong, 0);
  EXPECT_GT(Run(options, "5 * i + 1/5 * i + 2").wrong, 0) << "another word of a struct";
  EXPECT_GT(Run(options, "5 * i/6 * i").wrong, 0) << "another size of a struct";
  EXPECT_GT(Run(options, ".xy.x/.xy.y").wrong, 0) << "another component";
  EXPECT_GT(Run(options, "memory[i + 1u]/memory[i + 2u]").wrong, 0) << "another word";
  EXPECT_GT(Run(options, "uint i = address/uint i = 4u + address").wrong, 0) << "another address";
}

TEST_F(ComparedShaders, MistakesOnVulkanAreSeen) {
  if (const std::string why = vulkan::Runner::WhyNone(); !why.empty()) GTEST_SKIP() << why;
  const BuildOptions planes =
      Options("vulkan", Lowering::kClipDistance, {.negative_one_to_one = true, .flip_y = true});
  ASSERT_EQ(Run(planes).wrong, 0);
  EXPECT_GT(Run(planes, "= dot(/= -dot(").wrong, 0) << "sign";
  EXPECT_GT(Run(planes, "2.0 */1.999 *").wrong, 0) << "depth range";
  EXPECT_GT(Run(planes, " * 3/ * 4").wrong, 0) << "an int";
  const BuildOptions objects = Objects("vulkan");
  ASSERT_EQ(Run(objects).wrong, 0);
  EXPECT_GT(Run(objects, "sampler2D(colors/sampler2D(others").wrong, 0) << "another texture";
  EXPECT_GT(Run(objects, "pages[1]/pages[0]").wrong, 0) << "another element";
  EXPECT_GT(
      Run(objects, "in_POSITION0.xyz, in_POSITION0.w/in_POSITION0.xyz, in_POSITION0.w - 0.5").wrong,
      0)
      << "reference";
  EXPECT_GT(Run(objects, "memory[i + 1u]/memory[i + 2u]").wrong, 0) << "another word";
  EXPECT_GT(Run(objects, "5 * i + 1/5 * i + 2").wrong, 0) << "another word of a struct";
}

TEST_F(ComparedShaders, MistakesInDispatchesAreSeen) {
  for (const char* target : {"glsl430", "essl310", "vulkan"}) {
    if (target == std::string("vulkan") && !vulkan::Runner::WhyNone().empty()) continue;
    BuildOptions options = Options(target, Lowering::kNone);
    options.path = group_path;
    options.profile = "cs_5_0";
    ASSERT_EQ(Run(options).wrong, 0) << target;
    EXPECT_GT(Run(options, "] + 3u/] + 2u").wrong, 0) << target << ": a number";
    EXPECT_GT(Run(options, "7u - i/6u - i").wrong, 0) << target << ": another thread";
    EXPECT_GT(Run(options, "24u * id.y/16u * id.y").wrong, 0) << target << ": another group";
    if (target == std::string("essl310")) continue;  // whose images nothing reads back
    EXPECT_GT(Run(options, "* 0.5/* 0.25").wrong, 0) << target << ": a texel";
  }
}

TEST_F(ComparedShaders, MistakesInPatchesAreSeen) {
  for (const char* target : {"glsl400", "glsl450", "essl320"}) {
    BuildOptions options = Options(target, Lowering::kNone);
    options.path = patch_path;
    options.profile = "hs_5_0";
    ASSERT_EQ(Run(options).wrong, 0) << target;
    EXPECT_GT(Run(options, "vs_POSITION0[1]/vs_POSITION0[0]").wrong, 0) << target << ": a corner";
    EXPECT_GT(Run(options, "hs_POSITION0[1]/hs_POSITION0[2]").wrong, 0) << target << ": a point";
    EXPECT_GT(Run(options, "Outer[1] =/Outer[0] =").wrong, 0) << target << ": a factor";
    EXPECT_GT(Run(options, "5.0/4.0").wrong, 0) << target << ": the inside";
    EXPECT_GT(Run(options, "InvocationID == 0/InvocationID == 3").wrong, 0) << target << ": nobody";
  }
}

// The shader reads the bindings and locations that the application is told of, and no others.
TEST_F(ComparedShaders, WrongPlacesOnVulkanAreSeen) {
  if (const std::string why = vulkan::Runner::WhyNone(); !why.empty()) GTEST_SKIP() << why;
  const BuildOptions planes = Options("vulkan", Lowering::kNone);
  EXPECT_THAT([&] { Run(planes, "binding = 0/binding = 7"); },
              ::testing::ThrowsMessage<DrawError>(::testing::HasSubstr("has no value")));
  EXPECT_THAT(
      [&] { Run(planes, "location = 1) in/location = 5) in"); },
      ::testing::ThrowsMessage<DrawError>(::testing::HasSubstr("location 5, has no value")));
}

// After the end of a texture or buffer every value is right.
TEST_F(ComparedShaders, WhatLiesOutsideIsOpen) {
  const BuildOptions options = Objects();
  const Shader shader = Build(options);
  const auto open = [&](int greatest_int, const std::string& name) {
    const RandomInputs inputs =
        MakeRandomInputs(shader.typed, {.seed = 5, .vertices = 40, .greatest_int = greatest_int});
    long count = 0;
    for (const Expected& output : MakeExpected(shader, options, inputs)) {
      if (output.name == name) count += std::ranges::count(output.open, true);
    }
    return count;
  };
  EXPECT_EQ(open(2, "vs_ITEM0"), 0);
  EXPECT_EQ(open(2, "vs_LOADED0"), 0);
  EXPECT_EQ(open(2, "vs_BYTES0"), 0);
  for (const char* name : {"vs_ITEM0", "vs_LOADED0", "vs_BYTES0"})
    EXPECT_GT(open(5000, name), 100) << name;
  EXPECT_LT(open(5000, "vs_COLOR0"), 20) << "only what is near a border between texels";
}

TEST_F(ComparedShaders, MistakesWithAtomicOperationsAreSeen) {
  std::ofstream(objects_path) << "RWStructuredBuffer<int> b; float4 main(uint i : SV_VertexID) : "
                                 "SV_Position { int old; InterlockedMin(b[i], -3, old); "
                                 "InterlockedAdd(b[i], 5); return float4(old, b[i], 0, 1); }";
  const BuildOptions options = Objects();
  ASSERT_EQ(Run(options).wrong, 0);
  EXPECT_GT(Run(options, "atomicMin/atomicMax").wrong, 0) << "another operation";
  EXPECT_GT(Run(options, ", 5)/, 6)").wrong, 0) << "another value";
  EXPECT_GT(Run(options, "old = atomic/old = -3; atomic").wrong, 0) << "the value before it";
  std::ofstream(objects_path) << kObjects;
}

TEST_F(ComparedShaders, ImagesThatRoundAreRefused) {
  std::ofstream(objects_path) << "[[vk::image_format(\"rgba8\")]] RWTexture2D<float4> t;\n"
                                 "float4 main(uint2 i : I) : SV_Position { return t[i]; }";
  const ir::Program program = Build(Objects()).typed;
  std::ofstream(objects_path) << kObjects;
  const RandomOptions options;
  RandomValues values(options);
  const Buffer texels = MakeImage(program, program.resources.at(0).var, values);
  try {
    UploadedImage(program, program.resources.at(0), texels);
    FAIL();
  } catch (const DrawError& error) {
    EXPECT_STREQ(error.what(), "an image of the format rgba8, which no test draws with");
  }
}

TEST(RandomInputs, DependOnTheSeedOnly) {
  ir::Program program;
  ir::Var var;
  var.name = "p";
  var.type = program.types.Vector(ir::Scalar::kFloat, 4);
  var.storage = ir::Storage::kInput;
  program.inputs.push_back({.var = program.vars.Add(var), .semantic = "POSITION"});
  const auto values = [&](std::uint32_t seed) {
    return MakeRandomInputs(program, {.seed = seed}).vertices;
  };
  EXPECT_EQ(values(1), values(1));
  EXPECT_NE(values(1), values(2));
  EXPECT_EQ(values(1).size(), 64u);
}

// The places of components, by Microsoft's packing rules.
TEST(Memory, ComponentsInTheOrderOfTheValue) {
  ir::TypeTable types;
  const auto bytes_of = [&](ir::TypeId type, bool row_major) {
    Words bytes;
    ForEachComponent(types, type, row_major, 32,
                     [&](ir::Scalar, std::uint32_t byte) { bytes.push_back(byte); });
    return bytes;
  };
  using ::testing::ElementsAre;
  const ir::TypeId float2x3 = types.Matrix(ir::Scalar::kFloat, 2, 3);
  EXPECT_THAT(bytes_of(types.Vector(ir::Scalar::kInt, 3), false), ElementsAre(32, 36, 40));
  EXPECT_THAT(bytes_of(float2x3, false), ElementsAre(32, 48, 64, 36, 52, 68));
  EXPECT_THAT(bytes_of(float2x3, true), ElementsAre(32, 36, 40, 48, 52, 56));
  EXPECT_THAT(bytes_of(types.Array(types.Make(ir::Scalar::kFloat), 3), false),
              ElementsAre(32, 48, 64));
  ir::Struct inner;
  for (const int components : {3, 2}) {
    ir::Field& field = inner.fields.emplace_back();
    field.type = types.Vector(ir::Scalar::kFloat, components);
  }
  EXPECT_THAT(bytes_of(types.Of(types.AddStruct(inner)), false), ElementsAre(32, 36, 40, 48, 52));
}

TEST(Buffers, StructuredElementsLieTight) {
  ir::TypeTable types;
  ir::Struct item;
  const auto add = [&](ir::TypeId type, bool row_major = false) {
    ir::Field& field = item.fields.emplace_back();
    field.type = type;
    field.row_major = row_major;
  };
  add(types.Vector(ir::Scalar::kFloat, 3));
  add(types.Matrix(ir::Scalar::kFloat, 2, 3));
  add(types.Matrix(ir::Scalar::kFloat, 1, 2), true);
  add(types.Array(types.Make(ir::Scalar::kUint), 2));
  const ir::TypeId type = types.Of(types.AddStruct(item));
  Words bytes;
  ForEachComponent(
      types, type, false, 0, [&](ir::Scalar, std::uint32_t byte) { bytes.push_back(byte); },
      Packing::kStructured);
  EXPECT_THAT(bytes, ::testing::ElementsAre(0, 4, 8, 12, 20, 28, 16, 24, 32, 36, 40, 44, 48));
  EXPECT_EQ(StructuredSizeOf(types, type).size, 52u);
}

// A struct begins at, and takes, multiples of its largest component.
TEST(Buffers, DoublesAreAligned) {
  ir::TypeTable types;
  ir::Struct item;
  for (const ir::Scalar kind : {ir::Scalar::kInt, ir::Scalar::kDouble, ir::Scalar::kBool}) {
    item.fields.emplace_back().type = types.Make(kind);
  }
  const ir::TypeId type = types.Of(types.AddStruct(item));
  Words bytes;
  ForEachComponent(
      types, type, false, 0, [&](ir::Scalar, std::uint32_t byte) { bytes.push_back(byte); },
      Packing::kStructured);
  EXPECT_THAT(bytes, ::testing::ElementsAre(0, 8, 16));
  EXPECT_EQ(StructuredSizeOf(types, type).size, 24u);
}

}  // namespace
}  // namespace clipc::draw
