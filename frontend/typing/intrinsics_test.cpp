// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/typing/intrinsics.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frontend/typing/program_for_test.h"

namespace clipc::typing {
namespace {

// Checks a call with variables a, b, c of these types. Returns "type: expression !codes", or the
// messages.
std::string Call(std::string_view name, const std::vector<std::string>& types) {
  ProgramForTest test;
  std::vector<ir::ExprId> arguments;
  for (std::size_t i = 0; i < types.size(); ++i)
    arguments.push_back(test.Var(std::string(1, static_cast<char>('a' + i)), types[i]));
  const ir::ExprId call =
      CheckIntrinsicCall({test.program, name, {}, arguments, {}, test, test.diagnostics});
  if (test.program.exprs[call].type == test.program.types.Error()) {
    EXPECT_TRUE(test.diagnostics.has_errors()) << name;
    return test.Said();
  }
  EXPECT_FALSE(test.diagnostics.has_errors()) << name;
  std::string codes;
  for (const Diagnostic& each : test.diagnostics.all()) codes += MessageSuffix(each);
  const std::string text = test.Text(call);
  EXPECT_EQ(test.Broken(call), "") << text;
  return text + codes;
}

TEST(IntrinsicsTest, ComponentWise) {
  EXPECT_EQ(Call("abs", {"float3"}), "float3: abs(a)");
  EXPECT_EQ(Call("abs", {"int2"}), "int2: abs(a)");
  EXPECT_EQ(Call("abs", {"uint"}), "uint: abs(a)");
  EXPECT_EQ(Call("abs", {"double"}), "double: abs(a)");
  EXPECT_EQ(Call("abs", {"bool"}), "float: abs(convert<float>(a))");
  EXPECT_EQ(Call("sin", {"int"}), "float: sin(convert<float>(a))");
  EXPECT_EQ(Call("sin", {"float4x3"}), "float4x3: sin(a)");
  EXPECT_EQ(Call("sqrt", {"half2"}), "half2: sqrt(a)");
  EXPECT_EQ(Call("sqrt", {"min16float"}), "min16float: sqrt(a)");
  EXPECT_EQ(Call("sqrt", {"double"}), "float: sqrt(convert<float>(a)) [-Wimplicit-narrowing]");
  EXPECT_EQ(Call("saturate", {"int"}), "float: saturate(convert<float>(a))");
  EXPECT_EQ(Call("sign", {"float3"}), "int3: sign(a)");
  EXPECT_EQ(Call("sign", {"int"}), "int: sign(a)");
  EXPECT_EQ(Call("isnan", {"float2"}), "bool2: isnan(a)");
  EXPECT_EQ(Call("rcp", {"float1"}), "float1: rcp(a)");
  EXPECT_EQ(Call("rcp", {"double2"}), "double2: rcp(a)");
  EXPECT_EQ(Call("saturate", {"double"}), "double: saturate(a)");
}

TEST(IntrinsicsTest, VectorsOfFixedSize) {
  EXPECT_EQ(Call("msad4", {"uint", "uint2", "uint4"}), "uint4: msad4(a, b, c)");
  EXPECT_EQ(Call("msad4", {"int", "uint3", "uint4"}),
            "uint4: msad4(convert<uint>(a), b.xy, c) [-Wimplicit-truncation]");
}

TEST(IntrinsicsTest, ArgumentsUnify) {
  EXPECT_EQ(Call("max", {"float3", "float"}), "float3: max(a, splat<float3>(b))");
  EXPECT_EQ(Call("max", {"int", "float"}), "float: max(convert<float>(a), b)");
  EXPECT_EQ(Call("max", {"int", "uint"}), "uint: max(convert<uint>(a), b)");
  EXPECT_EQ(Call("min", {"float4", "float2"}), "float2: min(a.xy, b) [-Wimplicit-truncation]");
  EXPECT_EQ(Call("lerp", {"float3", "float3", "float"}), "float3: lerp(a, b, splat<float3>(c))");
  EXPECT_EQ(Call("lerp", {"half3", "float3", "float"}),
            "float3: lerp(convert<float3>(a), b, splat<float3>(c))");
  EXPECT_EQ(Call("pow", {"float", "int"}), "float: pow(a, convert<float>(b))");
  EXPECT_EQ(Call("clamp", {"float3", "int", "int"}),
            "float3: clamp(a, splat<float3>(convert<float>(b)), splat<float3>(convert<float>(c)))");
  EXPECT_EQ(Call("mad", {"int2", "int2", "int"}), "int2: mad(a, b, splat<int2>(c))");
  EXPECT_EQ(Call("step", {"float", "float4x4"}), "float4x4: step(splat<float4x4>(a), b)");
  EXPECT_EQ(Call("ldexp", {"float", "int"}), "float: ldexp(a, convert<float>(b))");
  EXPECT_EQ(Call("max", {"float4", "float4x4"}),
            "argument 2 of `max` has type `float4x4`; it must be a scalar, vector or matrix "
            "[intrinsic-argument-type, X3013]");
}

TEST(IntrinsicsTest, Vectors) {
  EXPECT_EQ(Call("dot", {"float4", "float3"}), "float: dot(a.xyz, b) [-Wimplicit-truncation]");
  EXPECT_EQ(Call("dot", {"int3", "int3"}), "int: dot(a, b)");
  EXPECT_EQ(Call("dot", {"float3", "float"}), "float: dot(a, splat<float3>(b))");
  EXPECT_EQ(Call("normalize", {"int3"}), "float3: normalize(convert<float3>(a))");
  EXPECT_EQ(Call("normalize", {"float"}), "float: normalize(a)");
  EXPECT_EQ(Call("length", {"float1"}), "float: length(a.x)");
  EXPECT_EQ(Call("length", {"float3x3"}),
            "argument 1 of `length` has type `float3x3`; it must be a scalar or a vector "
            "[intrinsic-argument-type, X3013]");
  EXPECT_EQ(Call("distance", {"float2", "float2"}), "float: distance(a, b)");
  EXPECT_EQ(Call("cross", {"float3", "float4"}), "float3: cross(a, b.xyz) [-Wimplicit-truncation]");
  EXPECT_EQ(Call("cross", {"float2", "float3"}),
            "argument 1 of `cross` has type `float2`; it must be a vector of three "
            "[intrinsic-argument-type, X3013]");
  EXPECT_EQ(Call("reflect", {"float3", "float3"}), "float3: reflect(a, b)");
  EXPECT_EQ(Call("refract", {"float3", "float3", "float"}), "float3: refract(a, b, c)");
  EXPECT_EQ(Call("faceforward", {"float3", "float3", "float3"}), "float3: faceforward(a, b, c)");
  EXPECT_EQ(Call("lit", {"float", "float", "int"}), "float4: lit(a, b, convert<float>(c))");
  EXPECT_EQ(Call("dst", {"float4", "float4"}), "float4: dst(a, b)");
  EXPECT_EQ(Call("D3DCOLORtoUBYTE4", {"float4"}), "int4: D3DCOLORtoUBYTE4(a)");
  EXPECT_EQ(Call("all", {"bool"}), "bool: all(a)");
  EXPECT_EQ(Call("any", {"float4x4"}), "bool: any(a)");
}

TEST(IntrinsicsTest, Matrices) {
  EXPECT_EQ(Call("transpose", {"float4x3"}), "float3x4: transpose(a)");
  EXPECT_EQ(Call("transpose", {"bool2x2"}), "bool2x2: transpose(a)");
  EXPECT_EQ(Call("transpose", {"float4"}),
            "argument 1 of `transpose` has type `float4`; it must be a scalar or a matrix "
            "[intrinsic-argument-type, X3013]");
  EXPECT_EQ(Call("determinant", {"float3x3"}), "float: determinant(a)");
  EXPECT_EQ(Call("determinant", {"float4x3"}),
            "float: determinant(truncate<float3x3>(a)) [-Wimplicit-truncation]");
}

TEST(IntrinsicsTest, MulNineForms) {
  EXPECT_EQ(Call("mul", {"float", "float"}), "float: a * b");
  EXPECT_EQ(Call("mul", {"float", "float3"}), "float3: splat<float3>(a) * b");
  EXPECT_EQ(Call("mul", {"float3", "int"}), "float3: a * splat<float3>(convert<float>(b))");
  EXPECT_EQ(Call("mul", {"float", "float2x3"}), "float2x3: splat<float2x3>(a) * b");
  EXPECT_EQ(Call("mul", {"float2x3", "float"}), "float2x3: a * splat<float2x3>(b)");
  EXPECT_EQ(Call("mul", {"float3", "float3"}), "float: dot(a, b)");
  EXPECT_EQ(Call("mul", {"float4", "float4x3"}), "float3: mul(a, b)");
  EXPECT_EQ(Call("mul", {"float4x3", "float3"}), "float4: mul(a, b)");
  EXPECT_EQ(Call("mul", {"float4x3", "float3x2"}), "float4x2: mul(a, b)");
}

TEST(IntrinsicsTest, MulTruncates) {
  EXPECT_EQ(Call("mul", {"float3", "float4x4"}),
            "float4: mul(a, truncate<float3x4>(b)) [-Wimplicit-truncation]");
  EXPECT_EQ(Call("mul", {"float4", "float3x3"}), "float3: mul(a.xyz, b) [-Wimplicit-truncation]");
  EXPECT_EQ(Call("mul", {"float4x4", "float3"}),
            "float4: mul(truncate<float4x3>(a), b) [-Wimplicit-truncation]");
  EXPECT_EQ(Call("mul", {"float3x3", "float4"}), "float3: mul(a, b.xyz) [-Wimplicit-truncation]");
  EXPECT_EQ(Call("mul", {"float4x4", "float3x3"}),
            "float4x3: mul(truncate<float4x3>(a), b) [-Wimplicit-truncation]");
  EXPECT_EQ(Call("mul", {"float4", "float3"}), "float: dot(a.xyz, b) [-Wimplicit-truncation]");
  EXPECT_EQ(Call("mul", {"float1", "float4x4"}),
            "float4: splat<float4>(a.x) * truncate<float1x4>(b)[0u] [-Wimplicit-truncation]");
  EXPECT_EQ(Call("mul", {"float3x1", "float1"}),
            "float3: float3(a[0u].x, a[1u].x, a[2u].x) * splat<float3>(b.x)");
}

TEST(IntrinsicsTest, MulKinds) {
  EXPECT_EQ(Call("mul", {"int2", "int2x2"}), "int2: mul(a, b)");
  EXPECT_EQ(Call("mul", {"half3", "half3x3"}), "half3: mul(a, b)");
  EXPECT_EQ(Call("mul", {"half3", "float3x3"}), "float3: mul(convert<float3>(a), b)");
  EXPECT_EQ(Call("mul", {"float4", "bool4x4"}), "float4: mul(a, convert<float4x4>(b))");
  EXPECT_EQ(Call("mul", {"float4"}),
            "`mul` takes 2 arguments; 1 given [intrinsic-argument-count, X3013]");
}

TEST(IntrinsicsTest, Bits) {
  EXPECT_EQ(Call("asfloat", {"uint4"}), "float4: asfloat(a)");
  EXPECT_EQ(Call("asfloat", {"float"}), "float: a");
  EXPECT_EQ(Call("asint", {"float4x4"}), "int4x4: asint(a)");
  EXPECT_EQ(Call("asint", {"uint"}), "int: convert<int>(a)");
  EXPECT_EQ(Call("asuint", {"half2"}), "uint2: asuint(convert<float2>(a))");
  EXPECT_EQ(Call("asuint", {"bool"}),
            "argument 1 of `asuint` has type `bool`; it must be a float, int or uint, or a vector "
            "or matrix of them [intrinsic-argument-type, X3013]");
  EXPECT_EQ(Call("asuint", {"double", "uint", "uint"}), "void: asuint(a, b, c)");
  EXPECT_EQ(Call("asuint", {"double2", "int2", "uint2"}),
            "int2: (t1 = zero<uint2>), (asuint(a, t1, c), (b = convert<int2>(t1)))");
  EXPECT_EQ(Call("asdouble", {"uint2", "uint2"}), "double2: asdouble(a, b)");
  EXPECT_EQ(Call("countbits", {"int3"}), "uint3: countbits(convert<uint3>(a))");
  EXPECT_EQ(Call("firstbithigh", {"int"}), "uint: firstbithigh(a)");
  EXPECT_EQ(Call("firstbithigh", {"uint2"}), "uint2: firstbithigh(a)");
  EXPECT_EQ(Call("firstbitlow", {"uint"}), "uint: firstbitlow(a)");
  EXPECT_EQ(Call("f16tof32", {"uint2"}), "float2: f16tof32(a)");
  EXPECT_EQ(Call("f32tof16", {"float4"}), "uint4: f32tof16(a)");
  EXPECT_EQ(Call("fma", {"double", "double", "double"}), "double: fma(a, b, c)");
  EXPECT_EQ(Call("fma", {"float", "float", "float"}),
            "argument 1 of `fma` has type `float`; it must be a double, or a vector or matrix of "
            "doubles [intrinsic-argument-type, X3013]");
}

TEST(IntrinsicsTest, ResultsThroughArguments) {
  EXPECT_EQ(Call("sincos", {"float", "float", "float"}), "void: sincos(a, b, c)");
  EXPECT_EQ(Call("modf", {"float3", "float3"}), "float3: modf(a, b)");
  EXPECT_EQ(Call("frexp", {"float", "float"}), "float: frexp(a, b)");
  EXPECT_EQ(Call("sincos", {"float", "half", "float"}),
            "half: (t1 = zero<float>), (sincos(a, t1, c), (b = convert<half>(t1)))");
  EXPECT_EQ(Call("modf", {"float", "int"}),
            "float: (t1 = zero<float>), ((t2 = modf(a, t1)), ((b = convert<int>(t1)), t2))");
}

TEST(IntrinsicsTest, OutArgumentsAreTargets) {
  ProgramForTest test;
  const ir::ExprId sum =
      test.Make().BinaryOf(ir::BinaryOp::kAdd, test.Var("x", "float"), test.Var("y", "float"));
  const std::vector<ir::ExprId> arguments = {test.Var("a", "float"), sum};
  EXPECT_EQ(test.Text(CheckIntrinsicCall(
                {test.program, "modf", {}, arguments, {}, test, test.diagnostics})),
            "argument 2 of `modf` is written to; it must be a variable or a part of one "
            "[intrinsic-out-argument, X3025]");
  const ir::ExprId constant = test.Make().Ref(test.Constant("k", test.Make().Float(1)));
  const std::vector<ir::ExprId> to_constant = {test.Var("a", "float"), constant};
  EXPECT_EQ(test.Text(CheckIntrinsicCall(
                {test.program, "modf", {}, to_constant, {}, test, test.diagnostics})),
            "argument 2 of `modf` is written to; it must be a variable or a part of one "
            "[intrinsic-out-argument, X3025]");
}

TEST(IntrinsicsTest, SelectAndLogic) {
  EXPECT_EQ(Call("select", {"bool", "float3", "float3"}), "float3: a ? b : c");
  EXPECT_EQ(Call("select", {"bool3", "float3", "float"}), "float3: select(a, b, splat<float3>(c))");
  EXPECT_EQ(Call("select", {"bool4", "float3", "int3"}),
            "float3: select(a.xyz, b, convert<float3>(c)) [-Wimplicit-truncation]");
  EXPECT_EQ(Call("select", {"float", "int", "uint"}),
            "uint: convert<bool>(a) ? convert<uint>(b) : c");
  EXPECT_EQ(Call("and", {"bool2", "bool2"}), "bool2: a && b");
  EXPECT_EQ(Call("or", {"float", "bool"}), "bool: convert<bool>(a) || b");
  EXPECT_EQ(Call("NonUniformResourceIndex", {"uint"}), "uint: NonUniformResourceIndex(a)");
}

TEST(IntrinsicsTest, SelectEvaluatesBothSides) {
  ProgramForTest test;
  const auto effect = [&](const char* name) {
    return test.Make().AssignTo(test.Var(name, "float"), test.Make().Float(1));
  };
  const std::vector<ir::ExprId> arguments = {test.Var("c", "bool"), effect("x"), effect("y")};
  const ir::ExprId call =
      CheckIntrinsicCall({test.program, "select", {}, arguments, {}, test, test.diagnostics});
  EXPECT_EQ(test.Text(call), "float: (t1 = c), ((t2 = x = 1.0), ((t3 = y = 1.0), (t1 ? t2 : t3)))");
  EXPECT_EQ(test.Broken(call), "");
}

TEST(IntrinsicsTest, RefusedFamilies) {
  const auto suffix = [](std::string_view name) {
    const std::string said = Call(name, {"float"});
    return said.substr(said.rfind('['));
  };
  EXPECT_EQ(Call("ddx", {"float"}),
            "`ddx` is the difference between neighbouring pixels; a vertex shader has none "
            "[intrinsic-derivative, X4532]");
  EXPECT_EQ(Call("clip", {"float"}),
            "`clip` discards a pixel; a vertex shader clips with `[clipplanes(...)]` or with "
            "SV_ClipDistance [intrinsic-discard, X4532]");
  EXPECT_EQ(Call("tex2D", {"float"}),
            "`tex2D` gets the level of detail from neighbouring pixels; a vertex shader gives it "
            "in the last component of `tex2Dlod` [intrinsic-implicit-level, X4532]");
  EXPECT_EQ(Call("texCUBEbias", {"float"}),
            "`texCUBEbias` gets the level of detail from neighbouring pixels; a vertex shader "
            "gives it in the last component of `texCUBElod` [intrinsic-implicit-level, X4532]");
  EXPECT_EQ(suffix("EvaluateAttributeSnapped"), "[intrinsic-interpolation, X4532]");
  EXPECT_EQ(suffix("GetRenderTargetSampleCount"), "[intrinsic-render-target, X4532]");
  EXPECT_EQ(suffix("GroupMemoryBarrier"), "[intrinsic-barrier, X4532]");
  EXPECT_EQ(suffix("ProcessTriTessFactorsMax"), "[intrinsic-tessellation, X4532]");
  EXPECT_EQ(suffix("TraceRay"), "[intrinsic-ray-tracing, X4532]");
  EXPECT_EQ(suffix("SetMeshOutputCounts"), "[intrinsic-mesh, X4532]");
  EXPECT_EQ(suffix("noise"), "[intrinsic-noise, X3004]");
  EXPECT_EQ(suffix("NoSuchIntrinsic"), "[intrinsic-unsupported]");
  EXPECT_EQ(Call("abort", {}),
            "`abort` stops the shader; no target of clipc can do that [intrinsic-abort]");
  EXPECT_EQ(Call("printf", {}), "int: 0 [-Wintrinsic-debug]");
}

TEST(IntrinsicsTest, ProfilesLackSome) {
  ProgramForTest test;
  test.program.profile.name = "vs_4_0";
  test.program.profile.major = 4;
  const std::vector<ir::ExprId> arguments = {test.Var("a", "uint")};
  EXPECT_EQ(
      test.Text(CheckIntrinsicCall(
          {test.program, "reversebits", {}, arguments, {}, test, test.diagnostics})),
      "`reversebits` needs profile vs_5_0 or later; this is `vs_4_0` [intrinsic-profile, X4532]");
  EXPECT_EQ(test.Text(CheckIntrinsicCall(
                {test.program, "asfloat", {}, arguments, {}, test, test.diagnostics})),
            "float: asfloat(a)");
}

TEST(IntrinsicsTest, ErrorsSilenceWhatFollows) {
  ProgramForTest test;
  const std::vector<ir::ExprId> arguments = {test.Make().ZeroOf(test.program.types.Error())};
  const ir::ExprId call =
      CheckIntrinsicCall({test.program, "max", {}, arguments, {}, test, test.diagnostics});
  EXPECT_EQ(test.program.exprs[call].type, test.program.types.Error());
  EXPECT_EQ(test.Said(), "");
}

TEST(IntrinsicsTest, NotNumbers) {
  ProgramForTest test;
  const std::vector<ir::ExprId> arguments = {test.Object("t", ir::ObjectKind::kTexture2D),
                                             test.Var("a", "float")};
  for (const char* name : {"max", "mul", "dot", "and"}) {
    EXPECT_THAT(test.Text(CheckIntrinsicCall(
                    {test.program, name, {}, arguments, {}, test, test.diagnostics})),
                testing::EndsWith("[intrinsic-argument-type, X3013]"));
  }
  const std::vector<ir::ExprId> one = {arguments[0]};
  for (const char* name : {"abs", "asfloat", "firstbithigh", "transpose"}) {
    EXPECT_THAT(
        test.Text(CheckIntrinsicCall({test.program, name, {}, one, {}, test, test.diagnostics})),
        testing::EndsWith("[intrinsic-argument-type, X3013]"));
  }
}

TEST(IntrinsicsTest, Names) {
  EXPECT_TRUE(IsIntrinsicName("saturate"));
  EXPECT_TRUE(IsIntrinsicName("ddx"));
  EXPECT_TRUE(IsIntrinsicName("tex2Dlod"));
  EXPECT_FALSE(IsIntrinsicName("Saturate"));
  EXPECT_FALSE(IsIntrinsicName(""));
  EXPECT_EQ(NearIntrinsics("normalise"), (std::vector<std::string_view>{"normalize"}));
  EXPECT_EQ(NearIntrinsics("Lerp"), (std::vector<std::string_view>{"lerp"}));
  EXPECT_EQ(NearIntrinsics("staurate").front(), "saturate");
  EXPECT_TRUE(NearIntrinsics("MyShadingFunction").empty());
}

}  // namespace
}  // namespace clipc::typing
