// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/literal.h"

#include <cstdlib>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "ir/scalar.h"

namespace clipc::glsl {
namespace {

using ir::BitsOf;
using ir::Scalar;

std::string Of(std::uint64_t bits, Scalar kind, const char* target = "glsl450") {
  return LiteralText(bits, kind, *Target::Parse(target)).text;
}
std::string Of(float value, const char* target = "glsl450") {
  return Of(BitsOf(value), Scalar::kFloat, target);
}

TEST(LiteralTest, FloatsAreShort) {
  EXPECT_EQ(Of(0.5f), "0.5");
  EXPECT_EQ(Of(1.0f), "1.0");
  EXPECT_EQ(Of(-0.0f), "-0.0");
  EXPECT_EQ(Of(0.1f), "0.1");
  EXPECT_EQ(Of(1e20f), "1e+20");
  EXPECT_EQ(Of(16777216.0f), "16777216.0");
}

TEST(LiteralTest, FloatsReadBackToTheSameBits) {
  std::mt19937 random(7);
  for (int i = 0; i < 100000; ++i) {
    const std::uint32_t bits = static_cast<std::uint32_t>(random());
    if ((bits & 0x7f800000u) == 0x7f800000u) continue;
    ASSERT_EQ(BitsOf(std::strtof(Of(bits, Scalar::kFloat).c_str(), nullptr)), bits);
  }
}

TEST(LiteralTest, WhatNoDecimalSays) {
  EXPECT_EQ(Of(std::numeric_limits<float>::infinity()), "uintBitsToFloat(0x7f800000u)");
  EXPECT_EQ(Of(std::numeric_limits<float>::quiet_NaN()), "uintBitsToFloat(0x7fc00000u)");
  EXPECT_EQ(Of(-std::numeric_limits<float>::infinity(), "glsl130"), "-1.0 / 0.0");
}

TEST(LiteralTest, Integers) {
  EXPECT_EQ(Of(BitsOf(-5), Scalar::kInt), "-5");
  EXPECT_EQ(Of(BitsOf(std::numeric_limits<int>::min()), Scalar::kInt), "int(0x80000000u)");
  EXPECT_EQ(Of(BitsOf(std::numeric_limits<int>::min()), Scalar::kInt, "glsl120"),
            "-2147483647 - 1");
  EXPECT_EQ(Of(BitsOf(5u), Scalar::kUint), "5u");
  EXPECT_EQ(Of(BitsOf(5u), Scalar::kUint, "glsl120"), "5");
  EXPECT_EQ(Of(1, Scalar::kBool), "true");
  EXPECT_EQ(Of(BitsOf(0.1), Scalar::kDouble), "0.1lf");
}

}  // namespace
}  // namespace clipc::glsl
