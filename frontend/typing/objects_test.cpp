// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/typing/objects.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "frontend/typing/intrinsics.h"
#include "frontend/typing/program_for_test.h"

namespace clipc::typing {
namespace {

using ir::ObjectKind;

// A test of calls t.method(arguments); an argument is a variable named by its type ("float2"), "s"
// (a SamplerState), "c" (a comparison sampler) or a number.
class ObjectsTest : public testing::Test {
 protected:
  ir::ExprId Argument(const std::string& text) {
    if (text == "s") return test_.Object("s", ObjectKind::kSampler);
    if (text == "c") return test_.Object("c", ObjectKind::kSamplerComparison);
    if (text[0] >= '0' && text[0] <= '9') return test_.Make().Int(std::stoi(text));
    return test_.Var(text + "_" + std::to_string(++count_), text);
  }
  std::string Call(ObjectKind kind, std::string_view method,
                   const std::vector<std::string>& arguments, std::string_view element = "") {
    test_ = ProgramForTest();
    count_ = 0;
    const ir::TypeId element_type = element.empty() ? ir::TypeId{} : test_.Type(element);
    const ir::ExprId object = test_.Object("t", kind, element_type);
    std::vector<ir::ExprId> expressions;
    for (const std::string& each : arguments) expressions.push_back(Argument(each));
    return test_.Text(CheckMethodCall(
        {test_.program, method, {}, expressions, {}, test_, test_.diagnostics}, object));
  }
  std::string Index(ObjectKind kind, const std::string& index, std::string_view element = "",
                    const std::string& level = "") {
    test_ = ProgramForTest();
    count_ = 0;
    const ir::ExprId object =
        test_.Object("t", kind, element.empty() ? ir::TypeId{} : test_.Type(element));
    const ir::ExprId at = Argument(index);
    const auto mip = level.empty() ? std::nullopt : std::optional(Argument(level));
    return test_.Text(CheckObjectIndex(test_.program, {object, at, mip}, test_.diagnostics));
  }

  ProgramForTest test_;
  int count_ = 0;
};

TEST_F(ObjectsTest, Samples) {
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "SampleLevel", {"s", "float2", "0"}),
            "float4: sample_level(t, s, float2_1, level: 0.0)");
  EXPECT_EQ(Call(ObjectKind::kTexture1D, "SampleLevel", {"s", "float", "float"}, "float3"),
            "float3: sample_level(t, s, float_1, level: float_2)");
  EXPECT_EQ(Call(ObjectKind::kTextureCubeArray, "SampleLevel", {"s", "float4", "float"}, "half"),
            "half: sample_level(t, s, float4_1, level: float_2)");
  EXPECT_EQ(Call(ObjectKind::kTexture2DArray, "SampleLevel", {"s", "float3", "float", "1"}),
            "float4: sample_level(t, s, float3_1, level: float_2, offset: int2(1, 1))");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "SampleGrad", {"s", "float2", "float2", "float2"}),
            "float4: sample_grad(t, s, float2_1, ddx: float2_2, ddy: float2_3)");
  EXPECT_EQ(Call(ObjectKind::kTextureCube, "SampleGrad", {"s", "float3", "float3", "float3"}),
            "float4: sample_grad(t, s, float3_1, ddx: float3_2, ddy: float3_3)");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "SampleCmpLevelZero", {"c", "float2", "float"}),
            "float: sample_cmp_level_zero(t, c, float2_1, reference: float_2)");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "Gather", {"s", "float2"}, "float"),
            "float4: gather(t, s, float2_1)");
  EXPECT_EQ(Call(ObjectKind::kTextureCube, "GatherBlue", {"s", "float3"}, "uint4"),
            "uint4: gather_blue(t, s, float3_1)");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "GatherCmp", {"c", "float2", "float"}),
            "float4: gather_cmp(t, c, float2_1, reference: float_2)");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "GatherCmpGreen", {"c", "float2", "float"}),
            "float4: gather_cmp(t, c, float2_1, reference: float_2)");
}

TEST_F(ObjectsTest, SamplesRefused) {
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "CalculateLevelOfDetail", {"s", "float2"}),
            "`CalculateLevelOfDetail` needs the level of detail of neighbouring pixels; a vertex "
            "shader has none [method-implicit-level, X4532]");
  EXPECT_EQ(Call(ObjectKind::kTexture3D, "Gather", {"s", "float3"}),
            "`Texture3D` has no method `Gather` [method-unknown, X3018]");
  EXPECT_EQ(Call(ObjectKind::kTexture3D, "SampleCmpLevelZero", {"c", "float3", "float"}),
            "`Texture3D` has no method `SampleCmpLevelZero` [method-unknown, X3018]");
  EXPECT_EQ(Call(ObjectKind::kTexture2DMS, "SampleLevel", {"s", "float2", "0"}),
            "`Texture2DMS` has no method `SampleLevel` [method-unknown, X3018]");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "SampleLevel", {"c", "float2", "0"}),
            "argument 1 of `SampleLevel` has type `SamplerComparisonState`; it must be a "
            "`SamplerState` [intrinsic-argument-type, X3013]");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "SampleLevel", {"s", "float2"}),
            "`SampleLevel` takes 3 or 4 arguments; 2 given [intrinsic-argument-count, X3013]");
  EXPECT_EQ(Call(ObjectKind::kTextureCube, "SampleLevel", {"s", "float3", "0", "1"}),
            "`SampleLevel` takes 3 arguments; 4 given [intrinsic-argument-count, X3013]");
  EXPECT_EQ(Call(ObjectKind::kTextureCube, "SampleLevel", {"s", "float2", "0"}),
            "argument 2 of `SampleLevel` has type `float2`; it must be `float3` "
            "[intrinsic-argument-type, X3013]");
  // KnowOffsets finds out whether it is constant.
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "SampleLevel", {"s", "float2", "0", "int2"}),
            "float4: sample_level(t, s, float2_1, level: 0.0, offset: int2_2)");
  EXPECT_EQ(
      Call(ObjectKind::kTexture2D, "SampleLevel", {"s", "float2", "0", "8"}),
      "offset 8 is given to `SampleLevel`; it must be from -8 to 7 [texture-offset-range, X4566]");
  // A status may be any number. The texel goes into a variable, in four components.
  EXPECT_EQ(
      Call(ObjectKind::kTexture2D, "SampleLevel", {"s", "float2", "0", "1", "uint"}, "float2"),
      "float2: (uint_2 = sample_level(t, s, float2_1, level: 0.0, offset: int2(1, 1), texel: t1)), "
      "t1.xy");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "SampleLevel", {"s", "float2", "0", "0", "float"}),
            "float4: (float_2 = convert<float>(sample_level(t, s, float2_1, level: 0.0, texel: "
            "t1))), t1");
  EXPECT_EQ(
      Call(ObjectKind::kTexture2D, "SampleGrad", {"s", "float2", "float2", "float2", "0", "int"}),
      "float4: sample_grad(t, s, float2_1, ddx: float2_2, ddy: float2_3, clamp: "
      "convert<float>(int_4))");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "Frobnicate", {}),
            "`Texture2D` has no method `Frobnicate` [method-unknown, X3018]");
  EXPECT_EQ(Call(ObjectKind::kSampler, "SampleLevel", {}),
            "`SamplerState` has no method `SampleLevel` [method-unknown, X3018]");
  EXPECT_EQ(Call(ObjectKind::kOther, "Store", {"0", "0"}),
            "`Store` is used on an object that a vertex shader may declare but not use "
            "[object-unusable, X4532]");
}

TEST_F(ObjectsTest, Loads) {
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "Load", {"int3"}),
            "float4: texture_load(t, int3_1.xy, level: int3_1.z)");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "Load", {"uint3", "1"}, "uint4"),
            "uint4: texture_load(t, convert<int2>(uint3_1.xy), level: convert<int>(uint3_1.z), "
            "offset: int2(1, 1))");
  EXPECT_EQ(Call(ObjectKind::kTexture1D, "Load", {"int2"}, "float"),
            "float: texture_load(t, int2_1.x, level: int2_1.y)");
  EXPECT_EQ(Call(ObjectKind::kTexture3D, "Load", {"int4"}),
            "float4: texture_load(t, int4_1.xyz, level: int4_1.w)");
  EXPECT_EQ(Call(ObjectKind::kTexture2DArray, "Load", {"int4"}),
            "float4: texture_load(t, int4_1.xyz, level: int4_1.w)");
  EXPECT_EQ(Call(ObjectKind::kTexture2DMS, "Load", {"int2", "int"}),
            "float4: texture_load(t, int2_1, level: int_2)");
  EXPECT_EQ(Call(ObjectKind::kTextureCube, "Load", {"int4"}),
            "`TextureCube` has no method `Load` [method-unknown, X3018]");
  EXPECT_EQ(
      Call(ObjectKind::kTexture2D, "Load", {"int2"}),
      "argument 1 of `Load` has type `int2`; it must be `int3` [intrinsic-argument-type, X3013]");
  EXPECT_EQ(Call(ObjectKind::kBuffer, "Load", {"uint"}, "float2"),
            "float2: buffer_load(t, convert<int>(uint_1))");
  EXPECT_EQ(Call(ObjectKind::kStructuredBuffer, "Load", {"int"}, "float4"),
            "float4: structured_load(t, int_1)");
  EXPECT_EQ(Call(ObjectKind::kStructuredBuffer, "Load", {"int", "uint"}, "float4"),
            "`Load` has a status of tiled resources; no target has one for a buffer "
            "[method-status]");
  EXPECT_EQ(Call(ObjectKind::kByteAddressBuffer, "Load", {"int"}),
            "uint: byte_load(t, convert<uint>(int_1))");
  EXPECT_EQ(Call(ObjectKind::kByteAddressBuffer, "Load3", {"uint"}), "uint3: byte_load(t, uint_1)");
  EXPECT_EQ(Call(ObjectKind::kByteAddressBuffer, "Store", {"uint", "uint"}),
            "`ByteAddressBuffer` has no method `Store` [method-unknown, X3018]");
}

// The place and the level are taken from the constructor that makes them; only a computed value is
// put into a variable.
TEST_F(ObjectsTest, LoadsTakeConstructorsApart) {
  const ir::ExprId texture = test_.Object("t", ObjectKind::kTexture2D);
  const auto load = [&](ir::ExprId place) {
    const std::vector<ir::ExprId> arguments = {place};
    return test_.Text(CheckMethodCall(
        {test_.program, "Load", {}, arguments, {}, test_, test_.diagnostics}, texture));
  };
  ir::Builder make(test_.program);
  EXPECT_EQ(load(make.ConstructOf(test_.Type("int3"), {test_.Var("p", "int2"), make.Int(0)})),
            "float4: texture_load(t, p, level: 0)");
  EXPECT_EQ(load(make.ConstructOf(test_.Type("int3"), {test_.Var("x", "int"), test_.Var("y", "int"),
                                                       test_.Var("z", "int")})),
            "float4: texture_load(t, int2(x, y), level: z)");
  EXPECT_EQ(load(make.ConstructOf(test_.Type("uint3"), {test_.Var("q", "uint2"), make.Uint(0)})),
            "float4: texture_load(t, convert<int2>(q), level: 0)");
  EXPECT_EQ(
      load(make.ConstructOf(test_.Type("int3"), {test_.Var("u", "int"), test_.Var("v", "int2")})),
      "float4: (t1 = int3(u, v)), texture_load(t, t1.xy, level: t1.z)");
  EXPECT_EQ(load(make.BinaryOf(ir::BinaryOp::kAdd, test_.Var("i", "int3"), test_.Var("j", "int3"))),
            "float4: (t2 = i + j), texture_load(t, t2.xy, level: t2.z)");
}

TEST_F(ObjectsTest, GetDimensions) {
  EXPECT_EQ(Call(ObjectKind::kTexture1D, "GetDimensions", {"uint"}),
            "uint: uint_1 = convert<uint>(texture_size(t, level: 0u))");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "GetDimensions", {"float", "uint"}),
            "uint: (t1 = texture_size(t, level: 0u)), ((float_1 = convert<float>(t1.x)), (uint_2 = "
            "convert<uint>(t1.y)))");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "GetDimensions", {"0", "uint", "uint", "uint"}),
            "uint: (t1 = texture_size(t, level: 0u)), ((uint_1 = convert<uint>(t1.x)), ((uint_2 = "
            "convert<uint>(t1.y)), (uint_3 = convert<uint>(texture_levels(t)))))");
  EXPECT_EQ(Call(ObjectKind::kTexture2DMS, "GetDimensions", {"uint", "uint", "uint"}),
            "uint: (t1 = texture_size(t, level: 0u)), ((uint_1 = convert<uint>(t1.x)), ((uint_2 = "
            "convert<uint>(t1.y)), (uint_3 = convert<uint>(texture_samples(t)))))");
  EXPECT_EQ(Call(ObjectKind::kTexture2DArray, "GetDimensions", {"uint", "uint", "uint"}),
            "uint: (t1 = texture_size(t, level: 0u)), ((uint_1 = convert<uint>(t1.x)), ((uint_2 = "
            "convert<uint>(t1.y)), (uint_3 = convert<uint>(t1.z))))");
  EXPECT_EQ(Call(ObjectKind::kBuffer, "GetDimensions", {"uint"}),
            "uint: uint_1 = convert<uint>(buffer_size(t))");
  EXPECT_EQ(Call(ObjectKind::kStructuredBuffer, "GetDimensions", {"uint", "uint"}, "float4x3"),
            "uint: (uint_1 = convert<uint>(buffer_size(t))), (uint_2 = 48u)");
  EXPECT_EQ(Call(ObjectKind::kByteAddressBuffer, "GetDimensions", {"uint"}),
            "uint: uint_1 = convert<uint>(buffer_size(t))");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "GetDimensions", {"uint"}),
            "`GetDimensions` takes 2 arguments; 1 given [intrinsic-argument-count, X3013]");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "GetDimensions", {"uint2", "uint"}),
            "argument 1 of `GetDimensions` has type `uint2`; it must be a uint or float variable "
            "[intrinsic-argument-type, X3013]");
  EXPECT_EQ(Call(ObjectKind::kTexture2D, "GetDimensions", {"uint", "1"}),
            "argument 2 of `GetDimensions` is written to; it must be a variable or a part of one "
            "[intrinsic-out-argument, X3025]");
}

TEST_F(ObjectsTest, Indices) {
  EXPECT_EQ(Index(ObjectKind::kTexture2D, "uint2"),
            "float4: texture_load(t, convert<int2>(uint2_1), level: 0)");
  EXPECT_EQ(Index(ObjectKind::kTexture1D, "int", "float3"),
            "float3: texture_load(t, int_1, level: 0)");
  EXPECT_EQ(Index(ObjectKind::kTexture2D, "int2", "", "int"),
            "float4: texture_load(t, int2_1, level: int_2)");
  EXPECT_EQ(Index(ObjectKind::kTexture2DMS, "int2", "float4", "int"),
            "float4: texture_load(t, int2_1, level: int_2)");
  EXPECT_EQ(Index(ObjectKind::kTexture2D, "int"),
            "the index has type `int`; it must be `int2` [object-index-type, X3120]");
  EXPECT_EQ(Index(ObjectKind::kTexture2D, "int3"),
            "the index has type `int3`; it must be `int2` [object-index-type, X3120]");
  EXPECT_EQ(Index(ObjectKind::kBuffer, "uint", "float4"),
            "float4: buffer_load(t, convert<int>(uint_1))");
  EXPECT_EQ(Index(ObjectKind::kStructuredBuffer, "uint", "float4"),
            "float4: structured_load(t, uint_1)");
  EXPECT_EQ(Index(ObjectKind::kStructuredBuffer, "float", "float4"),
            "float4: structured_load(t, convert<int>(float_1))");
  EXPECT_EQ(Index(ObjectKind::kByteAddressBuffer, "uint"),
            "`ByteAddressBuffer` has no elements or texels to index [object-not-indexed, X3121]");
  EXPECT_EQ(Index(ObjectKind::kTextureCube, "uint"),
            "`TextureCube` has no elements or texels to index [object-not-indexed, X3121]");
  EXPECT_EQ(Index(ObjectKind::kOther, "uint"),
            "`[]` is used on an object that a vertex shader may declare but not use "
            "[object-unusable, X4532]");
}

TEST_F(ObjectsTest, Direct3d9) {
  const auto lod = [&](std::string_view name, ObjectKind sampler, ir::ExprId place) {
    const std::vector<ir::ExprId> arguments = {test_.Object("s", sampler), place};
    return test_.Text(
        CheckIntrinsicCall({test_.program, name, {}, arguments, {}, test_, test_.diagnostics}));
  };
  EXPECT_EQ(lod("tex2Dlod", ObjectKind::kSampler2D, test_.Var("p", "float4")),
            "float4: d3d9_sample_level(s, p.xy, level: p.w)");
  EXPECT_EQ(lod("tex2Dlod", ObjectKind::kSampler, test_.Var("q", "float4")),
            "float4: d3d9_sample_level(s.1, q.xy, level: q.w)");
  ir::Builder make(test_.program);
  const ir::ExprId place = make.ConstructOf(
      test_.Type("float4"), {test_.Var("uv", "float2"), make.Float(0), make.Float(0)});
  EXPECT_EQ(lod("tex2Dlod", ObjectKind::kSampler2D, place),
            "float4: d3d9_sample_level(s.2, uv, level: 0.0)");
  EXPECT_EQ(lod("texCUBElod", ObjectKind::kSamplerCube, test_.Var("r", "float4")),
            "float4: d3d9_sample_level(s.3, r.xyz, level: r.w)");
  EXPECT_EQ(lod("tex1Dlod", ObjectKind::kSampler1D, test_.Var("l", "half4")),
            "float4: d3d9_sample_level(s.4, convert<float>(l.x), level: convert<float>(l.w))");
  EXPECT_EQ(lod("tex2Dlod", ObjectKind::kSampler3D, test_.Var("w", "float4")),
            "argument 1 of `tex2Dlod` has type `sampler3D`; it must be a `sampler2D` "
            "[intrinsic-argument-type, X3013]");
  EXPECT_EQ(lod("tex3Dlod", ObjectKind::kSampler3D, test_.Var("z", "float3")),
            "argument 2 of `tex3Dlod` has type `float3`; it must be `float4` "
            "[intrinsic-argument-type, X3013]");
}

TEST_F(ObjectsTest, WhatIsMadeIsWellTyped) {
  const ir::ExprId texture = test_.Object("t", ObjectKind::kTexture2D);
  const std::vector<ir::ExprId> arguments = {test_.Make().Int(0), test_.Var("w", "uint"),
                                             test_.Var("h", "float"), test_.Var("n", "uint")};
  const ir::ExprId call = CheckMethodCall(
      {test_.program, "GetDimensions", {}, arguments, {}, test_, test_.diagnostics}, texture);
  test_.program.resources.push_back(
      {std::get<ir::VarRef>(test_.program.exprs[texture].node).var, {.letter = 't'}});
  EXPECT_EQ(test_.Broken(call), "");
}

}  // namespace
}  // namespace clipc::typing
