// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/names.h"

#include <gtest/gtest.h>

namespace clipc::glsl {
namespace {

TEST(NamesTest, LegalNamesStay) {
  EXPECT_EQ(LegalName("world_view"), "world_view");
  EXPECT_EQ(LegalName("_x"), "_x");
  EXPECT_EQ(LegalName("p0"), "p0");
  EXPECT_EQ(LegalFieldName("distance"), "distance") << "a field may be called like a function";
  EXPECT_EQ(LegalFieldName("length"), "length_") << "but not like the method of arrays";
  EXPECT_EQ(LegalTypeName("location"), "location_") << "`layout(location = 0)` has to stay";
}

TEST(NamesTest, WhatGlslReservesGetsASuffix) {
  EXPECT_EQ(LegalName("input"), "input_");
  EXPECT_EQ(LegalName("texture"), "texture_");
  EXPECT_EQ(LegalName("half"), "half_");
  EXPECT_EQ(LegalName("dot"), "dot_");
  EXPECT_EQ(LegalName("vec4"), "vec4_");
  EXPECT_EQ(LegalFieldName("sample"), "sample_");
}

TEST(NamesTest, UnderscoresAndPrefixes) {
  EXPECT_EQ(LegalName("a__b___c"), "a_b_c");
  EXPECT_EQ(LegalName("gl_Position"), "_gl_Position");
  EXPECT_EQ(LegalName("GL_ES"), "_GL_ES");
  EXPECT_EQ(LegalName("webgl_matrix"), "x_webgl_matrix");
  EXPECT_EQ(LegalName("_webgl_matrix"), "x_webgl_matrix");
  EXPECT_EQ(LegalName("ns::plane"), "ns_plane");
  EXPECT_EQ(LegalName("$Globals"), "Globals");
  EXPECT_EQ(LegalName("2d"), "_2d");
  EXPECT_EQ(LegalName(""), "unnamed");
  EXPECT_EQ(LegalName("__"), "unnamed");
}

TEST(NamesTest, CollidingGlobalsAreNumbered) {
  Namer namer;
  EXPECT_EQ(namer.Global("a"), "a");
  EXPECT_EQ(namer.Global("a"), "a_2");
  EXPECT_EQ(namer.Global("a_2"), "a_2_2");
  EXPECT_EQ(namer.Global("a"), "a_3");
  EXPECT_EQ(namer.Global("input"), "input_");
  EXPECT_EQ(namer.Global("input"), "input_2");
  EXPECT_EQ(namer.Global("max3"), "max3_") << "a function of an extension";
  EXPECT_EQ(namer.Global("max3"), "max3_2");
}

TEST(NamesTest, SiblingScopesShareNamesAndInnerOnesDoNotShadow) {
  Namer namer;
  namer.Global("g");
  namer.OpenScope();
  EXPECT_EQ(namer.Local("i"), "i");
  EXPECT_EQ(namer.Local("g"), "g_2");
  namer.OpenScope();
  EXPECT_EQ(namer.Local("i"), "i_2");
  namer.CloseScope();
  namer.OpenScope();
  EXPECT_EQ(namer.Local("i"), "i_2");
  namer.CloseScope();
  namer.CloseScope();
  namer.OpenScope();
  EXPECT_EQ(namer.Local("i"), "i");
  namer.CloseScope();
  EXPECT_EQ(namer.Global("i"), "i_3") << "a helper function is visible in functions written before";
}

}  // namespace
}  // namespace clipc::glsl
