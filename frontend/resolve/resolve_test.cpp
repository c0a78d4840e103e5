// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/resolve.h"

#include <filesystem>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace clipc::resolve {
namespace {

TEST(Resolve, HasATestOfEachPass) {
  for (const std::string_view pass : ResolvePasses()) {
    const std::string file = "testdata/passes/resolve/" + std::string(pass) + ".hlsl";
    EXPECT_TRUE(std::filesystem::is_regular_file(file)) << file;
  }
}

}  // namespace
}  // namespace clipc::resolve
