// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/path.h"

#include <gtest/gtest.h>

namespace clipc {
namespace {

TEST(Path, ANameBeginsAfterTheLastSlash) {
  EXPECT_EQ(NameBegin("water.hlsl"), 0u);
  EXPECT_EQ(NameBegin("a/b/water.hlsl"), 4u);
  EXPECT_EQ(NameBegin("a/"), 2u);
  EXPECT_EQ(NameBegin(""), 0u);
}

TEST(Path, SlashesAndRoots) {
  EXPECT_TRUE(HasSlash("a/b"));
  EXPECT_FALSE(HasSlash("ab"));
  EXPECT_TRUE(EndsWithSlash("a/"));
  EXPECT_FALSE(EndsWithSlash("a/b"));
  EXPECT_FALSE(EndsWithSlash(""));
  EXPECT_TRUE(IsAbsolute("/a"));
  EXPECT_FALSE(IsAbsolute("a/b"));
  EXPECT_FALSE(IsAbsolute(""));
}

TEST(Path, BackslashesAndDrivesAreThoseOfWindows) {
  EXPECT_EQ(HasSlash("a\\b"), kHasDrives);
  EXPECT_EQ(EndsWithSlash("a\\"), kHasDrives);
  EXPECT_EQ(IsAbsolute("C:\\a"), kHasDrives);
  EXPECT_EQ(IsAbsolute("\\\\server\\a"), kHasDrives);
  EXPECT_EQ(NameBegin("a\\b"), kHasDrives ? 2u : 0u);
  EXPECT_EQ(NameBegin("C:b"), kHasDrives ? 2u : 0u);
}

}  // namespace
}  // namespace clipc
