// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/target.h"

#include <gtest/gtest.h>

namespace clipc::glsl {
namespace {

Target Of(std::string_view name) { return *Target::Parse(name); }

TEST(TargetTest, EveryNameParsesToItself) {
  for (std::string_view name : Target::Names()) {
    ASSERT_TRUE(Target::Parse(name)) << name;
    EXPECT_EQ(Target::Parse(name)->name(), name);
  }
  EXPECT_FALSE(Target::Parse("glsl110"));
  EXPECT_FALSE(Target::Parse("essl200"));
  EXPECT_FALSE(Target::Parse(""));
  EXPECT_EQ(Of("GLSL450").name(), "glsl450");
}

TEST(TargetTest, VersionLines) {
  EXPECT_EQ(Of("glsl120").VersionLine(), "#version 120");
  EXPECT_EQ(Of("essl100").VersionLine(), "#version 100");
  EXPECT_EQ(Of("essl310").VersionLine(), "#version 310 es");
  EXPECT_EQ(Of("vulkan").VersionLine(), "#version 460");
}

TEST(TargetTest, VersionGates) {
  EXPECT_FALSE(Of("glsl150").Has(Feature::kInputLocations));
  EXPECT_TRUE(Of("glsl330").Has(Feature::kInputLocations));
  EXPECT_FALSE(Of("glsl400").Has(Feature::kOutputLocations));
  EXPECT_TRUE(Of("glsl410").Has(Feature::kOutputLocations));
  EXPECT_FALSE(Of("glsl410").Has(Feature::kBindings));
  EXPECT_TRUE(Of("glsl420").Has(Feature::kBindings));
  EXPECT_FALSE(Of("glsl420").Has(Feature::kComputeShaders));
  EXPECT_TRUE(Of("glsl430").Has(Feature::kComputeShaders));
  EXPECT_FALSE(Of("webgl2").Has(Feature::kComputeShaders));
  EXPECT_EQ(Of("webgl2").NearestWith(Feature::kComputeShaders), "glsl430");
  EXPECT_EQ(Of("essl300").NearestWith(Feature::kComputeShaders), "essl310");
  EXPECT_FALSE(Of("glsl430").Has(Feature::kExplicitOffsets));
  EXPECT_TRUE(Of("glsl440").Has(Feature::kExplicitOffsets));
  EXPECT_FALSE(Of("glsl140").Has(Feature::kBlockInstances));
  EXPECT_TRUE(Of("glsl150").Has(Feature::kBlockInstances));
  EXPECT_FALSE(Of("glsl330").Has(Feature::kPrecise));
  EXPECT_TRUE(Of("glsl400").Has(Feature::kPrecise));
  EXPECT_FALSE(Of("glsl120").Has(Feature::kBitCasts));
  EXPECT_EQ(Of("glsl150").Of(Feature::kBitCasts).extension, "GL_ARB_shader_bit_encoding");
  EXPECT_EQ(Of("glsl330").Of(Feature::kBitCasts).extension, "");
  EXPECT_EQ(Of("glsl450").Of(Feature::kDrawParameters).extension, "GL_ARB_shader_draw_parameters");
  EXPECT_EQ(Of("glsl460").Of(Feature::kDrawParameters).extension, "");
  EXPECT_FALSE(Of("essl320").Has(Feature::kDrawParameters));
  EXPECT_FALSE(Of("glsl120").Has(Feature::kClipDistance));
  EXPECT_EQ(Of("essl300").Of(Feature::kClipDistance).extension, "GL_EXT_clip_cull_distance");
  EXPECT_EQ(Of("webgl2").Of(Feature::kClipDistance).extension, "GL_ANGLE_clip_cull_distance");
  EXPECT_FALSE(Of("webgl2").Has(Feature::kPerSample)) << "no extension of WebGL 2";
  EXPECT_FALSE(Of("webgl2").Has(Feature::kOutputBlocks)) << "nor this";
  EXPECT_FALSE(Of("webgl2").Has(Feature::kSampleVariables)) << "nor gl_SampleID";
  EXPECT_TRUE(Of("essl300").Has(Feature::kSampleVariables));
  EXPECT_FALSE(Of("webgl2").Has(Feature::kInterpolants));
  EXPECT_TRUE(Of("glsl130").Has(Feature::kClipVertex));
  for (const Feature feature : {Feature::kFreeLoops, Feature::kFreeIndices, Feature::kArrayValues,
                                Feature::kStructChoices, Feature::kFullMatrices, Feature::kCentroid,
                                Feature::kUniformTransposes, Feature::kTexture3D}) {
    EXPECT_TRUE(Of("glsl120").Has(feature));
    EXPECT_TRUE(Of("essl300").Has(feature));
    EXPECT_FALSE(Of("essl100").Has(feature));
    EXPECT_FALSE(Of("webgl1").Has(feature));
  }
  EXPECT_FALSE(Of("webgl1").Has(Feature::kClipDistance)) << "no extension of WebGL 1";
  EXPECT_FALSE(Of("glsl140").Has(Feature::kClipVertex));
}

}  // namespace
}  // namespace clipc::glsl
