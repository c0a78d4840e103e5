// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/semantics.h"

#include <gtest/gtest.h>

namespace clipc::signature {
namespace {

using Use = SystemValue::Use;
using enum Use;

struct Expected {
  const char* name;
  Use vertex_input, vertex_output, pixel_input, pixel_output;
};

Use UseOf(const char* name, Stage stage, Direction direction, bool is_old = false,
          std::uint32_t index = 0) {
  return LookUpSemantic(name, index, stage, direction, is_old).use;
}

// A compute shader has the numbers of its threads and groups, and no data.
TEST(Semantics, ComputeShadersHaveNumbersOfThreads) {
  for (const char* name :
       {"SV_DispatchThreadID", "SV_GroupID", "sv_groupthreadid", "SV_GroupIndex"}) {
    EXPECT_EQ(UseOf(name, Stage::kCompute, Direction::kInput), kBuiltin) << name;
    EXPECT_EQ(UseOf(name, Stage::kCompute, Direction::kOutput), kRefused) << name;
    EXPECT_EQ(UseOf(name, Stage::kVertex, Direction::kInput), kRefused) << name;
    EXPECT_EQ(UseOf(name, Stage::kPixel, Direction::kInput), kMade) << name;
  }
  for (const char* name : {"SV_Position", "SV_VertexID", "SV_Target", "POSITION", "COLOR", "VPOS",
                           "TEXCOORD", "SV_Unknown", "vk::PointSize"}) {
    EXPECT_EQ(UseOf(name, Stage::kCompute, Direction::kInput), kRefused) << name;
    EXPECT_EQ(UseOf(name, Stage::kCompute, Direction::kOutput), kRefused) << name;
  }
  EXPECT_EQ(NearSystemValue("SV_GroupThreadId_", Stage::kCompute, Direction::kInput),
            "SV_GroupThreadID");
}

// The oracle is Microsoft's page "Semantics (HLSL)", its tables of system values and of Direct3D
// 9's semantics, and for the values of shader model 6 the columns VSIn, VSOut, PSIn and PSOut of
// DXC's signature table. An output of the vertex shader that the page gives to no stage is data.
TEST(Semantics, EachSystemValueOnEachSideOfEachStage) {
  constexpr Expected kExpected[] = {
      {"SV_Position", kPlain, kBuiltin, kBuiltin, kRefused},
      {"SV_ClipDistance", kPlain, kBuiltin, kBuiltin, kRefused},
      {"SV_CullDistance", kPlain, kBuiltin, kBuiltin, kRefused},
      {"SV_VertexID", kBuiltin, kPlain, kMade, kRefused},
      {"SV_InstanceID", kBuiltin, kPlain, kPlain, kRefused},
      {"SV_PrimitiveID", kRefused, kPlain, kBuiltin, kRefused},
      {"SV_RenderTargetArrayIndex", kPlain, kBuiltin, kBuiltin, kRefused},
      {"SV_ViewportArrayIndex", kPlain, kBuiltin, kBuiltin, kRefused},
      {"SV_ShadingRate", kPlain, kBuiltin, kBuiltin, kRefused},
      {"SV_ViewID", kBuiltin, kPlain, kBuiltin, kRefused},
      {"SV_StartVertexLocation", kBuiltin, kRefused, kRefused, kRefused},
      {"SV_StartInstanceLocation", kBuiltin, kRefused, kRefused, kRefused},
      {"SV_IsFrontFace", kRefused, kRefused, kBuiltin, kRefused},
      {"SV_SampleIndex", kRefused, kRefused, kBuiltin, kRefused},
      {"SV_InnerCoverage", kRefused, kRefused, kBuiltin, kRefused},
      {"SV_Barycentrics", kRefused, kRefused, kBuiltin, kRefused},
      {"SV_Coverage", kRefused, kRefused, kBuiltin, kBuiltin},
      {"SV_Target", kRefused, kRefused, kRefused, kTarget},
      {"SV_Depth", kRefused, kRefused, kRefused, kBuiltin},
      {"SV_DepthGreaterEqual", kRefused, kRefused, kRefused, kBuiltin},
      {"SV_DepthLessEqual", kRefused, kRefused, kRefused, kBuiltin},
      {"SV_StencilRef", kRefused, kRefused, kRefused, kBuiltin},
      {"VPOS", kPlain, kPlain, kBuiltin, kRefused},
      {"VFACE", kPlain, kPlain, kBuiltin, kRefused},
      {"COLOR", kPlain, kPlain, kPlain, kTarget},
      {"DEPTH", kPlain, kPlain, kPlain, kBuiltin},
      {"TEXCOORD", kPlain, kPlain, kPlain, kRefused},
  };
  for (const Expected& row : kExpected) {
    EXPECT_EQ(UseOf(row.name, Stage::kVertex, Direction::kInput), row.vertex_input) << row.name;
    EXPECT_EQ(UseOf(row.name, Stage::kVertex, Direction::kOutput), row.vertex_output) << row.name;
    EXPECT_EQ(UseOf(row.name, Stage::kPixel, Direction::kInput), row.pixel_input) << row.name;
    EXPECT_EQ(UseOf(row.name, Stage::kPixel, Direction::kOutput), row.pixel_output) << row.name;
  }
}

TEST(Semantics, UnknownSystemValues) {
  for (const char* name : {"SV_DispatchThreadID", "sv_nothing", "vk::Nothing"}) {
    EXPECT_EQ(UseOf(name, Stage::kVertex, Direction::kInput), kRefused) << name;
    EXPECT_EQ(UseOf(name, Stage::kVertex, Direction::kOutput), kRefused) << name;
    EXPECT_EQ(UseOf(name, Stage::kPixel, Direction::kInput), kMade) << name;
  }
}

TEST(Semantics, NamesOfDirect3D9CountUnderItsProfiles) {
  for (const char* name : {"POSITION", "psize"}) {
    EXPECT_EQ(UseOf(name, Stage::kVertex, Direction::kOutput, true), kBuiltin) << name;
    EXPECT_EQ(UseOf(name, Stage::kVertex, Direction::kOutput, true, 1), kPlain) << name;
    EXPECT_EQ(UseOf(name, Stage::kVertex, Direction::kOutput, false), kPlain) << name;
    EXPECT_EQ(UseOf(name, Stage::kVertex, Direction::kInput, true), kPlain) << name;
    EXPECT_EQ(UseOf(name, Stage::kPixel, Direction::kInput, true), kLost) << name;
  }
  const auto with_both = [](const char* name) {
    return LookUpSemantic(name, 0, Stage::kVertex, Direction::kOutput, false, PositionName::kBoth)
        .use;
  };
  EXPECT_EQ(with_both("POSITION"), kBuiltin);
  EXPECT_EQ(with_both("PSIZE"), kPlain);
}

TEST(Semantics, NearestNameOfTheStageAndDirection) {
  EXPECT_EQ(NearSystemValue("SV_Positon", Stage::kVertex, Direction::kOutput), "SV_Position");
  EXPECT_EQ(NearSystemValue("SV_Positon", Stage::kVertex, Direction::kInput), "");
  EXPECT_EQ(NearSystemValue("SV_Positon", Stage::kPixel, Direction::kInput), "SV_Position");
  EXPECT_EQ(NearSystemValue("SV_VertxID", Stage::kVertex, Direction::kInput), "SV_VertexID");
}

}  // namespace
}  // namespace clipc::signature
