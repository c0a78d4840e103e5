// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/known_texts.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
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

  std::shared_ptr<KnownText> Share(const char* profile, std::uint64_t effect) {
    ProgramRequest request;
    request.first() = {.path = path_, .profile = profile};
    request.language.effect = effect;
    Diagnostics diagnostics(request.warnings);
    const Plan plan = Resolve(request, 0, diagnostics);
    return texts_.Get(context_, request, plan, InputOf(request, 0, plan, diagnostics));
  }
  const KnownText* Get(const char* profile, std::uint64_t effect = 1) {
    return Share(profile, effect).get();
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
  const KnownText* first = Get("vs_4_0");
  const KnownText* second = Get("vs_4_1");
  Get("vs_5_0");
  EXPECT_EQ(Get("vs_4_1"), second);
  EXPECT_NE(first, nullptr);
}

TEST_F(KnownTextsOfEffect, DropsThoseOfTheLastEffect) {
  Write(30);
  const std::weak_ptr<const KnownText> of_first = Share("vs_5_0", 1);
  EXPECT_EQ(Get("vs_5_0", 1), of_first.lock().get());
  Get("vs_5_0", 2);
  EXPECT_TRUE(of_first.expired());
}

}  // namespace
}  // namespace clipc
