// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/type.h"

#include <set>

#include <gtest/gtest.h>

#include "ir/profile.h"

namespace clipc::ir {
namespace {

TEST(TypeTable, EqualTypesHaveEqualIds) {
  TypeTable types;
  const TypeId float4 = types.Vector(Scalar::kFloat, 4);
  EXPECT_EQ(float4, types.Vector(Scalar::kFloat, 4));
  EXPECT_EQ(types.Array(float4, 6), types.Array(float4, 6));
  EXPECT_NE(types.Array(float4, 6), types.Array(float4, 5));
  EXPECT_NE(types.Make(Scalar::kFloat), types.Vector(Scalar::kFloat, 1));
  EXPECT_NE(types.Vector(Scalar::kFloat, 3), types.Matrix(Scalar::kFloat, 1, 3));
  EXPECT_EQ(types.Object(ObjectKind::kTexture2D, float4),
            types.Object(ObjectKind::kTexture2D, float4));
  EXPECT_NE(types.Object(ObjectKind::kTexture2D, float4),
            types.Object(ObjectKind::kTexture3D, float4));
  EXPECT_NE(types.Object(ObjectKind::kSampler), types.Object(ObjectKind::kByteAddressBuffer));
  const StructId a = types.AddStruct({.name = "A", .fields = {}, .span = {}});
  const StructId b = types.AddStruct({.name = "A", .fields = {}, .span = {}});
  EXPECT_EQ(types.Of(a), types.Of(a));
  EXPECT_NE(types.Of(a), types.Of(b));
}

TEST(TypeTable, EveryNumericTypeReadsBackAsAskedFor) {
  TypeTable types;
  std::set<TypeId> seen;
  for (int k = 0; k <= static_cast<int>(Scalar::kUint64); ++k) {
    const Scalar kind = static_cast<Scalar>(k);
    seen.insert(types.Make(kind));
    EXPECT_EQ(types[types.Make(kind)], (Type{.kind = TypeKind::kScalar, .scalar = kind}));
    for (int columns = 1; columns <= 4; ++columns) {
      const Type& vector = types[types.Vector(kind, columns)];
      seen.insert(types.Vector(kind, columns));
      EXPECT_EQ(vector.kind, TypeKind::kVector);
      EXPECT_EQ(vector.Components(), static_cast<std::uint32_t>(columns));
      for (int rows = 1; rows <= 4; ++rows) {
        const Type& matrix = types[types.Matrix(kind, rows, columns)];
        seen.insert(types.Matrix(kind, rows, columns));
        EXPECT_EQ(matrix.kind, TypeKind::kMatrix);
        EXPECT_EQ(matrix.rows, rows);
        EXPECT_EQ(matrix.columns, columns);
        EXPECT_EQ(matrix.scalar, kind);
      }
    }
  }
  EXPECT_EQ(seen.size(), 13u * 21u);
}

TEST(TypeTable, NamesAreHlsl) {
  TypeTable types;
  const TypeId light = types.Of(types.AddStruct({.name = "Light", .fields = {}, .span = {}}));
  EXPECT_EQ(types.Name(types.Make(Scalar::kUint)), "uint");
  EXPECT_EQ(types.Name(types.Vector(Scalar::kMin16Float, 3)), "min16float3");
  EXPECT_EQ(types.Name(types.Matrix(Scalar::kFloat, 4, 3)), "float4x3");
  EXPECT_EQ(types.Name(types.Array(types.Array(light, 3), 2)), "Light[2][3]");
  EXPECT_EQ(types.Name(types.Array(light, 0)), "Light[]");
  EXPECT_EQ(types.Name(types.Object(ObjectKind::kTexture2D, types.Vector(Scalar::kFloat, 4))),
            "Texture2D<float4>");
  EXPECT_EQ(types.Name(types.Object(ObjectKind::kSampler)), "SamplerState");
  EXPECT_EQ(types.Name(types.Void()), "void");
  EXPECT_EQ(types.Name(types.Error()), "<error>");
  EXPECT_EQ(types.Name(types.Of(types.AddStruct({}))), "<unnamed struct>");
}

TEST(TypeTable, WithScalarKeepsTheShape) {
  TypeTable types;
  EXPECT_EQ(types.WithScalar(types.Matrix(Scalar::kInt, 2, 3), Scalar::kBool),
            types.Matrix(Scalar::kBool, 2, 3));
  EXPECT_EQ(types.WithScalar(types.Void(), Scalar::kBool), types.Void());
}

TEST(Scalar, KindsFallIntoClasses) {
  EXPECT_EQ(BaseOf(Scalar::kHalf), Scalar::kFloat);
  EXPECT_EQ(BaseOf(Scalar::kMin16Uint), Scalar::kUint);
  EXPECT_EQ(BaseOf(Scalar::kInt64), Scalar::kInt64);
  EXPECT_TRUE(IsFloat(Scalar::kDouble));
  EXPECT_TRUE(IsFloat(Scalar::kMin10Float));
  EXPECT_FALSE(IsInteger(Scalar::kBool));
  EXPECT_TRUE(IsInteger(Scalar::kMin12Int));
  EXPECT_TRUE(IsUnsigned(Scalar::kUint64));
  EXPECT_FALSE(IsUnsigned(Scalar::kInt));
}

// The profile called `name`; an impossible profile if there is none.
Profile Parsed(std::string_view name) {
  return ParseProfile(name).value_or(Profile{.name = "none", .stage = {}});
}

TEST(Profile, VertexProfilesOfBothCompilers) {
  for (const char* name :
       {"vs_1_1", "vs_2_0", "vs_2_a", "vs_2_sw", "vs_3_0", "vs_3_sw", "vs_4_0", "vs_4_1", "vs_5_0",
        "vs_5_1", "vs_6_0", "vs_6_8", "vs_6_9", "vs_4_0_level_9_0", "vs_4_0_level_9_3"}) {
    EXPECT_EQ(Parsed(name).stage, Stage::kVertex) << name;
    EXPECT_EQ(Parsed(name).name, name);
  }
}

TEST(Profile, VersionAndLevel) {
  const Profile profile = Parsed("VS_4_0_Level_9_1");
  EXPECT_EQ(profile.name, "vs_4_0_level_9_1");
  EXPECT_EQ(profile.major, 4);
  EXPECT_EQ(profile.minor, 0);
  EXPECT_EQ(profile.level9, Level9::k9_1);
  EXPECT_FALSE(profile.IsDirect3D9());
  EXPECT_TRUE(Parsed("vs_3_sw").IsDirect3D9());
  EXPECT_TRUE(Parsed("vs_5_1").IsAtLeast(5, 0));
  EXPECT_FALSE(Parsed("vs_5_0").IsAtLeast(5, 1));
}

TEST(Profile, OtherStagesAreKnownAndNotVertex) {
  for (const char* name : {"ps_2_b", "ps_5_0", "gs_4_0", "hs_5_0", "ds_5_1", "cs_6_5", "lib_6_3",
                           "lib_6_x", "ms_6_5", "as_6_5", "fx_2_0", "rootsig_1_1"}) {
    EXPECT_EQ(Parsed(name).name, name);
    EXPECT_NE(Parsed(name).stage, Stage::kVertex) << name;
  }
  EXPECT_EQ(Parsed("ps_2_b").stage, Stage::kPixel);
  EXPECT_EQ(Parsed("lib_6_3").stage, std::nullopt);
  EXPECT_EQ(Parsed("lib_6_3").Prefix(), "lib");
}

TEST(Profile, UnknownNames) {
  for (const char* name : {"", "vs", "vs_", "vs_7_0", "vs_4_2", "vs_4_0_level_9_2", "vs_6_99",
                           "ms_6_0", "vs_5_0 ", "xs_5_0"}) {
    EXPECT_FALSE(ParseProfile(name)) << name;
  }
}

}  // namespace
}  // namespace clipc::ir
