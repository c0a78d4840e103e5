// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/known_texts.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace clipc {
namespace {

// An effect of `tokens` tokens, of which the last pass of compiles may still know the texts.
class KnownTextsOfEffect : public testing::Test {
 protected:
  ~KnownTextsOfEffect() override { std::filesystem::remove(path_); }

  void Write(std::size_t tokens) {
    std::ofstream file(path_);
    for (std::size_t i = 0; i < tokens / 3; ++i) file << "float a" << i << ";\n";
    file << "float4 main(float4 p : P) : SV_Position { return p; }\n";
  }

  const KnownText* Get(const char* profile, const char* define = "NONE") {
    ProgramRequest request;
    request.first() = {.path = path_, .profile = profile};
    request.language.is_in_effect = true;
    request.defines = {define};
    Diagnostics diagnostics(request.warnings);
    const Plan plan = Resolve(request, 0, diagnostics);
    return texts_.Get(context_, request, plan, InputOf(request, 0, plan, diagnostics)).get();
  }

 private:
  std::string path_ =
      testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".fx";
  FrontendContext context_{FrontendContext::Files::kOnDisk, ""};
  KnownTexts texts_;
};

TEST_F(KnownTextsOfEffect, KeepsTwoOfAnySize) {
  Write(240'000);
  const KnownText* vertex = Get("vs_5_0");
  const KnownText* pixel = Get("ps_5_0");
  ASSERT_NE(vertex, nullptr);
  ASSERT_NE(pixel, nullptr);
  EXPECT_EQ(Get("vs_5_0"), vertex) << "the text of pixel shaders does not drive it out";
  EXPECT_EQ(Get("ps_5_0"), pixel);
}

TEST_F(KnownTextsOfEffect, DropsTheOldest) {
  Write(90'000);
  const KnownText* first = Get("vs_5_0", "FIRST");
  const KnownText* second = Get("vs_5_0", "SECOND");
  Get("vs_5_0", "THIRD");
  EXPECT_EQ(Get("vs_5_0", "SECOND"), second);
  EXPECT_NE(first, nullptr);
}

}  // namespace
}  // namespace clipc
