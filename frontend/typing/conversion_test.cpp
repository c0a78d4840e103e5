// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/typing/conversion.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "frontend/typing/program_for_test.h"

namespace clipc::typing {
namespace {

std::string Implicit(std::string_view from, std::string_view to) {
  ProgramForTest test;
  const ir::ExprId value = test.Var("a", from);
  if (!RankImplicit(test.program.types, test.Type(from), test.Type(to))) return "no";
  const ir::ExprId converted =
      ConvertImplicit(test.program, value, test.Type(to), test.diagnostics, &test);
  const std::string said = test.Said();
  std::string text = ir::PrintExpr(test.program, converted);
  EXPECT_EQ(test.program.exprs[converted].type, test.Type(to)) << from << " to " << to;
  EXPECT_EQ(test.Broken(converted), "") << from << " to " << to;
  return text + (said.empty() ? "" : said.substr(said.rfind(" [")));
}

TEST(ConversionTest, KeepsTheSameType) {
  EXPECT_EQ(Implicit("float3", "float3"), "a");
  EXPECT_EQ(Implicit("min16float", "min16float"), "a");
}

TEST(ConversionTest, ChangesTheKind) {
  EXPECT_EQ(Implicit("int", "float"), "convert<float>(a)");
  EXPECT_EQ(Implicit("float3", "uint3"), "convert<uint3>(a)");
  EXPECT_EQ(Implicit("float4", "bool4"), "convert<bool4>(a)");
  EXPECT_EQ(Implicit("half4x4", "float4x4"), "convert<float4x4>(a)");
  EXPECT_EQ(Implicit("double", "float"), "convert<float>(a) [-Wimplicit-narrowing]");
}

TEST(ConversionTest, SplatsSingleComponents) {
  EXPECT_EQ(Implicit("float", "float4"), "splat<float4>(a)");
  EXPECT_EQ(Implicit("int", "float2x2"), "splat<float2x2>(convert<float>(a))");
  EXPECT_EQ(Implicit("float1", "float3"), "splat<float3>(a.x)");
  EXPECT_EQ(Implicit("float1x1", "float2"), "splat<float2>(a[0u].x)");
  EXPECT_EQ(Implicit("float", "float1"), "splat<float1>(a)");
  EXPECT_EQ(Implicit("float1", "float"), "a.x");
  EXPECT_EQ(Implicit("float1", "float1x1"), "splat<float1x1>(a.x)");
}

TEST(ConversionTest, TruncatesWithAWarning) {
  EXPECT_EQ(Implicit("float4", "float3"), "a.xyz [-Wimplicit-truncation]");
  EXPECT_EQ(Implicit("float4", "int2"), "convert<int2>(a.xy) [-Wimplicit-truncation]");
  EXPECT_EQ(Implicit("float4", "float"), "a.x [-Wimplicit-truncation]");
  EXPECT_EQ(Implicit("float4x4", "float"), "a[0u].x [-Wimplicit-truncation]");
  EXPECT_EQ(Implicit("float4x4", "float3x3"), "truncate<float3x3>(a) [-Wimplicit-truncation]");
  EXPECT_EQ(Implicit("int4x4", "float1x4"),
            "convert<float1x4>(truncate<int1x4>(a)) [-Wimplicit-truncation]");
}

TEST(ConversionTest, ReadsVectorsAsMatricesAndBack) {
  EXPECT_EQ(Implicit("float4", "float2x2"), "float2x2(a.xy, a.zw)");
  EXPECT_EQ(Implicit("float2x2", "float4"), "float4(a[0u], a[1u])");
  EXPECT_EQ(Implicit("float3", "float1x3"), "float1x3(a)");
  EXPECT_EQ(Implicit("float3", "float3x1"), "float3x1(a.x, a.y, a.z)");
  EXPECT_EQ(Implicit("float3x1", "float3"), "float3(a[0u].x, a[1u].x, a[2u].x)");
  EXPECT_EQ(Implicit("float1x3", "float3"), "a[0u]");
  EXPECT_EQ(Implicit("float1x4", "float2"), "a[0u].xy [-Wimplicit-truncation]");
  EXPECT_EQ(Implicit("float4", "float2x1"), "float2x1(a.x, a.y) [-Wimplicit-truncation]");
  EXPECT_EQ(Implicit("float3x1", "float2"), "float2(a[0u].x, a[1u].x) [-Wimplicit-truncation]");
}

// The rows of DXC's conversions-between-type-shapes.hlsl that both fxc and DXC refuse.
TEST(ConversionTest, RefusesWhatFxcAndDxcRefuse) {
  for (const auto& [from, to] :
       std::vector<std::pair<const char*, const char*>>{{"int2", "int4"},
                                                        {"int2", "int3"},
                                                        {"int1x2", "int4"},
                                                        {"int2x1", "int1x2"},
                                                        {"int1x2", "int2x1"},
                                                        {"int3x1", "int1x2"},
                                                        {"int1x3", "int2x1"},
                                                        {"int2x2", "int2"},
                                                        {"int3x3", "int2"},
                                                        {"int2", "int2x2"},
                                                        {"int2x2", "int3x3"},
                                                        {"int4", "int4x4"},
                                                        {"int4x1", "int4x4"},
                                                        {"float2x3", "float3x2"},
                                                        {"float3", "float2x2"}}) {
    EXPECT_EQ(Implicit(from, to), "no") << from << " to " << to;
    ProgramForTest test;
    EXPECT_FALSE(IsExplicitlyConvertible(test.program.types, test.Type(from), test.Type(to)))
        << from << " to " << to;
  }
}

TEST(ConversionTest, ConvertsLiteralsAtOnce) {
  ProgramForTest test;
  const auto text = [&](ir::ExprId value, const char* to) {
    return ir::PrintExpr(
        test.program, ConvertImplicit(test.program, value, test.Type(to), test.diagnostics, &test));
  };
  EXPECT_EQ(text(test.Make().Int(1), "float"), "1.0");
  EXPECT_EQ(text(test.Make().Int(0), "float4"), "splat<float4>(0.0)");
  EXPECT_EQ(text(test.Make().Float(2.5f), "int"), "2");
  EXPECT_EQ(text(test.Make().UnaryOf(ir::UnaryOp::kNegate, test.Make().Int(3)), "float"), "-3.0");
  // -0 is the integer 0, not the float -0.
  EXPECT_EQ(text(test.Make().UnaryOf(ir::UnaryOp::kNegate, test.Make().Int(0)), "float"),
            "convert<float>(-0)");
  EXPECT_EQ(
      text(test.Make().ConstructOf(test.Type("int2"), {test.Make().Int(1), test.Make().Int(2)}),
           "float2"),
      "float2(1.0, 2.0)");
  EXPECT_EQ(text(test.Make().LiteralOf(ir::Scalar::kDouble, 0.1), "float"), "0.1");
  EXPECT_EQ(test.Said(), "");
  const ir::ExprId pair =
      test.Make().ConstructOf(test.Type("int2"), {test.Make().Int(1), test.Make().Int(2)});
  EXPECT_EQ(test.Broken(ConvertImplicit(test.program, pair, test.Type("float2"), test.diagnostics)),
            "");
}

TEST(ConversionTest, FindsCommonTypes) {
  ProgramForTest test;
  const auto common = [&](const char* left, const char* right) {
    const auto type = CommonType(test.program.types, test.Type(left), test.Type(right));
    return type ? test.program.types.Name(*type) : "none";
  };
  EXPECT_EQ(common("int", "float"), "float");
  EXPECT_EQ(common("int", "uint"), "uint");
  EXPECT_EQ(common("bool", "bool"), "bool");
  EXPECT_EQ(common("bool", "int"), "int");
  EXPECT_EQ(common("half", "int"), "half");
  EXPECT_EQ(common("half", "float"), "float");
  EXPECT_EQ(common("min16float", "int"), "min16float");
  EXPECT_EQ(common("min16float", "float"), "float");
  EXPECT_EQ(common("min16uint", "min12int"), "min16uint");
  EXPECT_EQ(common("min16int", "uint"), "uint");
  EXPECT_EQ(common("double", "float"), "double");
  EXPECT_EQ(common("float3", "float4"), "float3");
  EXPECT_EQ(common("int4", "float"), "float4");
  EXPECT_EQ(common("float1", "float"), "float");
  EXPECT_EQ(common("float1", "int4"), "float4");
  // DXC's vector-matrix-binops.hlsl.
  EXPECT_EQ(common("float4x4", "float1x4"), "float1x4");
  EXPECT_EQ(common("float4x4", "float3x2"), "float3x2");
  EXPECT_EQ(common("float4", "float2x2"), "float4");
  EXPECT_EQ(common("float2x2", "float4"), "float2x2");
  EXPECT_EQ(common("float3", "float1x4"), "float3");
  EXPECT_EQ(common("float1x4", "float2"), "float2");
  EXPECT_EQ(common("float4", "float4x4"), "none");
  EXPECT_EQ(common("float2x3", "float3x2"), "none");
  EXPECT_EQ(common("float1x4", "float2x3"), "none");
}

// Sums of costs choose overloads as DXC's implicit-casts.hlsl says.
TEST(ConversionTest, RanksOverloadsAsDxc) {
  ProgramForTest test;
  const auto cost = [&](const char* from, const char* to) {
    return CostOf(*RankImplicit(test.program.types, test.Type(from), test.Type(to)));
  };
  // overload2(int4x4, float) takes the int version, overload2(half, float) the float version.
  EXPECT_LT(cost("int4x4", "int4x4") + cost("float", "int4x4"),
            cost("int4x4", "float4x4") + cost("float", "float4x4"));
  EXPECT_LT(cost("half", "float") + cost("float", "float"),
            cost("half", "half") + cost("float", "half"));
  // A splat costs less than any change of kind, a truncation more than all of them.
  EXPECT_LT(cost("float", "float4"), cost("float", "int"));
  EXPECT_LT(cost("float", "float4"), cost("half", "float"));
  EXPECT_LT(cost("float4", "int4"), cost("float4", "float3"));
  EXPECT_LT(cost("int", "uint"), cost("int", "float"));
  EXPECT_LT(cost("float4", "float4"), cost("float4", "float1x4"));
  EXPECT_LT(cost("float1", "float"), cost("float1", "float4"));
  EXPECT_EQ(cost("float", "float"), 0u);
}

TEST(ConversionTest, ConvertsStructsOfTheSameLeaves) {
  ProgramForTest test;
  const ir::TypeId a = test.Struct("A", {test.Type("float3"), test.Type("int")});
  const ir::TypeId b = test.Struct("B", {test.Type("float3"), test.Type("int")});
  const ir::TypeId c =
      test.Struct("C", {test.Type("float2"), test.Type("float"), test.Type("int")});
  const ir::TypeId d = test.Struct("D", {test.Type("float3"), test.Type("float")});
  const ir::ExprId value = test.Var("s", a);
  EXPECT_EQ(test.Text(ConvertImplicit(test.program, value, b, test.diagnostics)), "B: B{s.p, s.q}");
  EXPECT_EQ(test.Text(ConvertImplicit(test.program, value, c, test.diagnostics)),
            "C: C{s.p.xy, s.p.z, s.q}");
  EXPECT_FALSE(RankImplicit(test.program.types, a, d));
  EXPECT_TRUE(IsExplicitlyConvertible(test.program.types, a, d));
  EXPECT_EQ(test.Text(ConvertExplicit(test.program, value, d, test)),
            "D: D{s.p, convert<float>(s.q)}");
}

TEST(ConversionTest, HoldsImpureValuesInATemporary) {
  ProgramForTest test;
  const ir::TypeId a = test.Struct("A", {test.Type("float"), test.Type("float")});
  const ir::TypeId b = test.Struct("B", {test.Type("float"), test.Type("float")});
  const ir::ExprId value = test.Make().AssignTo(test.Var("s", a), test.Make().ZeroOf(a));
  const ir::ExprId converted = ConvertImplicit(test.program, value, b, test.diagnostics, &test);
  EXPECT_EQ(test.Text(converted), "B: (t1 = s = zero<A>), B{t1.p, t1.q}");
  EXPECT_EQ(test.Broken(converted), "");
}

TEST(ConversionTest, ReportsWhenNobodyMakesTemporaries) {
  ProgramForTest test;
  const ir::ExprId value =
      test.Make().BinaryOf(ir::BinaryOp::kAdd, test.Var("a", "float4"), test.Var("b", "float4"));
  EXPECT_EQ(
      test.Text(ConvertImplicit(test.program, value, test.Type("float2x2"), test.diagnostics)),
      "cannot convert from `float4` to `float2x2` here; store the value in a variable first "
      "[conversion-reads-twice, X3017]");
}

TEST(ConversionTest, DerivedConvertsToBase) {
  ProgramForTest test;
  const ir::TypeId base = test.Struct("Base", {test.Type("float3")});
  const ir::TypeId derived = test.Struct("Derived", {test.Type("float3"), test.Type("float")});
  EXPECT_TRUE(RankImplicit(test.program.types, derived, base));
  EXPECT_FALSE(RankImplicit(test.program.types, base, derived));
  EXPECT_EQ(
      test.Text(ConvertImplicit(test.program, test.Var("d", derived), base, test.diagnostics)),
      "Base: Base{d.p}");
}

TEST(ConversionTest, CastsFlatten) {
  ProgramForTest test;
  ir::TypeTable& types = test.program.types;
  const ir::TypeId array4 = types.Array(test.Type("float"), 4);
  const ir::TypeId lights = test.Struct("Light", {test.Type("float3"), test.Type("float")});
  const auto cast = [&](ir::ExprId value, ir::TypeId to) {
    EXPECT_TRUE(IsExplicitlyConvertible(types, test.program.exprs[value].type, to));
    return test.Text(ConvertExplicit(test.program, value, to, test));
  };
  EXPECT_EQ(cast(test.Var("s", lights), test.Type("float4")), "float4: float4(s.p, s.q)");
  EXPECT_EQ(cast(test.Var("v", "float4"), lights), "Light: Light{v.xyz, v.w}");
  EXPECT_EQ(cast(test.Var("w", "float4"), array4), "float[4]: float[4]{w.x, w.y, w.z, w.w}");
  EXPECT_EQ(cast(test.Var("x", array4), test.Type("float2x2")),
            "float2x2: float2x2(float2(x[0u], x[1u]), float2(x[2u], x[3u]))");
  EXPECT_EQ(cast(test.Var("l", lights), test.Type("int")), "int: convert<int>(l.p.x)");
  EXPECT_EQ(cast(test.Var("f", "float"), lights), "Light: Light{splat<float3>(f), f}");
  EXPECT_EQ(cast(test.Make().Int(0), types.Array(lights, 1000000)),
            "Light[1000000]: zero<Light[1000000]>");
  EXPECT_EQ(cast(test.Make().Int(1), lights), "Light: Light{splat<float3>(1.0), 1.0}");
  EXPECT_FALSE(
      IsExplicitlyConvertible(types, types.Array(test.Type("float"), 3), test.Type("float4")));
  EXPECT_FALSE(
      IsExplicitlyConvertible(types, types.Array(test.Type("float"), 1), test.Type("float2")));
  EXPECT_FALSE(
      IsExplicitlyConvertible(types, test.Type("float"), types.Object(ir::ObjectKind::kTexture2D)));
}

TEST(ConversionTest, FlatteningIsBounded) {
  ProgramForTest test;
  ir::TypeTable& types = test.program.types;
  ir::TypeId type = test.Type("float4");
  for (int i = 0; i < 40; ++i) type = test.Struct("S", {type, type});
  EXPECT_FALSE(Flatten(types, type));
  EXPECT_FALSE(IsExplicitlyConvertible(types, type, test.Type("float4")));
  ir::TypeId empty = test.Struct("Empty", {});
  for (int i = 0; i < 4; ++i) empty = types.Array(empty, 1u << 30);
  EXPECT_FALSE(Flatten(types, empty));
  ir::TypeId deep = test.Type("float");
  for (int i = 0; i < 100000; ++i) deep = test.Struct("D", {deep});
  EXPECT_FALSE(Flatten(types, deep));
  EXPECT_FALSE(IsExplicitlyConvertible(types, deep, test.Type("float")));
}

TEST(ConversionTest, ErrorsSilenceWhatFollows) {
  ProgramForTest test;
  const ir::TypeId error = test.program.types.Error();
  EXPECT_TRUE(RankImplicit(test.program.types, error, test.Type("float4x4")));
  EXPECT_EQ(CommonType(test.program.types, error, test.Type("float")), error);
  const ir::ExprId value = test.Make().ZeroOf(error);
  EXPECT_EQ(ConvertImplicit(test.program, value, test.Type("float"), test.diagnostics), value);
  EXPECT_EQ(test.Said(), "");
}

// The variable learns it from all of its uses, in SettleSamplers.
TEST(ConversionTest, AUseOfASamplerLearnsItsKind) {
  ProgramForTest test;
  const ir::ExprId sampler = test.Object("s", ir::ObjectKind::kSampler);
  const ir::TypeId wanted = test.program.types.Object(ir::ObjectKind::kSampler2D);
  ASSERT_TRUE(RankImplicit(test.program.types, test.program.exprs[sampler].type, wanted));
  EXPECT_EQ(
      test.program.exprs[ConvertImplicit(test.program, sampler, wanted, test.diagnostics)].type,
      wanted);
  EXPECT_NE(test.program.vars[std::get<ir::VarRef>(test.program.exprs[sampler].node).var].type,
            wanted);
}

}  // namespace
}  // namespace clipc::typing
