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
  EXPECT_FALSE(Target::Parse("essl100"));
  EXPECT_FALSE(Target::Parse(""));
  EXPECT_EQ(Of("GLSL450").name(), "glsl450");
}

TEST(TargetTest, VersionLines) {
  EXPECT_EQ(Of("glsl120").VersionLine(), "#version 120");
  EXPECT_EQ(Of("essl310").VersionLine(), "#version 310 es");
  EXPECT_EQ(Of("vulkan").VersionLine(), "#version 460");
}

// design/glsl.md, "Version gates".
TEST(TargetTest, VersionGates) {
  EXPECT_FALSE(Of("glsl150").HasInputLocations());
  EXPECT_TRUE(Of("glsl330").HasInputLocations());
  EXPECT_FALSE(Of("glsl400").HasOutputLocations());
  EXPECT_TRUE(Of("glsl410").HasOutputLocations());
  EXPECT_FALSE(Of("glsl410").HasBindings());
  EXPECT_TRUE(Of("glsl420").HasBindings());
  EXPECT_FALSE(Of("glsl430").HasExplicitOffsets());
  EXPECT_TRUE(Of("glsl440").HasExplicitOffsets());
  EXPECT_FALSE(Of("glsl140").HasBlockInstances());
  EXPECT_TRUE(Of("glsl150").HasBlockInstances());
  EXPECT_FALSE(Of("glsl330").HasPrecise());
  EXPECT_TRUE(Of("glsl400").HasPrecise());
  EXPECT_FALSE(Of("glsl120").BitCasts());
  EXPECT_EQ(Of("glsl150").BitCasts().extension(), "GL_ARB_shader_bit_encoding");
  EXPECT_EQ(Of("glsl330").BitCasts().extension(), "");
  EXPECT_EQ(Of("glsl450").DrawParameters().extension(), "GL_ARB_shader_draw_parameters");
  EXPECT_EQ(Of("glsl460").DrawParameters().extension(), "");
  EXPECT_FALSE(Of("essl320").DrawParameters());
  EXPECT_FALSE(Of("glsl120").ClipDistance());
  EXPECT_EQ(Of("essl300").ClipDistance().extension(), "GL_EXT_clip_cull_distance");
  EXPECT_TRUE(Of("glsl130").HasClipVertex());
  EXPECT_FALSE(Of("glsl140").HasClipVertex());
}

}  // namespace
}  // namespace clipc::glsl
