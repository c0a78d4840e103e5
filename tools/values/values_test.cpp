// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/harness/options.h"
#include "tools/values/run.h"

// The runner itself, on a file of this project: it draws what the file says, and it sees what is
// not the same.
namespace clipc::values {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Values : public ::testing::Test {
 protected:
  // The context is the child's: a fork after OpenGL has begun here would lack its threads.
  void SetUp() override {
    const FileResult nothing = RunIsolated("", kFamilies[0]);
    if (!nothing.probes.empty()) GTEST_SKIP() << nothing.probes[0].why;
  }

  static FileResult Run(Model least) {
    const auto* family = std::ranges::find(kFamilies, least, &Family::least);
    return RunIsolated(harness::ReadFile("tools/values/own.shader_test"), *family);
  }

  static std::vector<Verdict> VerdictsOf(const FileResult& result) {
    std::vector<Verdict> verdicts;
    for (const Probe& probe : result.probes) verdicts.push_back(probe.verdict);
    return verdicts;
  }
};

TEST_F(Values, DrawsWithDirect3D9sRegistersAndPixels) {
  const FileResult result = Run(0);
  const std::vector<Verdict> all(5, Verdict::kEqual);
  EXPECT_EQ(VerdictsOf(result), all) << result.probes.back().why;
  EXPECT_EQ(result.shaders.size(), 4u);
}

TEST_F(Values, DrawsWithConstantBuffers) {
  const std::vector<Verdict> all(4, Verdict::kEqual);
  EXPECT_EQ(VerdictsOf(Run(kModel6)), all);
}

TEST_F(Values, SeesWhatDiffersAndWhatItDoesNotDraw) {
  const FileResult result = Run(kModel4);
  ASSERT_EQ(result.probes.size(), 14u);
  const std::vector<Probe> last(result.probes.end() - 5, result.probes.end());
  EXPECT_TRUE(std::all_of(result.probes.begin(), result.probes.end() - 5,
                          [](const Probe& probe) { return probe.verdict == Verdict::kEqual; }));
  EXPECT_EQ(last[0].verdict, Verdict::kDifferent);
  EXPECT_EQ(last[0].why, "at (5, 5): is (1, 2, 3, 4), the test has (1, 2, 3.5, 4)");
  EXPECT_EQ(last[1].verdict, Verdict::kEqual);
  // With a geometry shader, and with a hull and a domain shader too.
  EXPECT_EQ(last[2].verdict, Verdict::kEqual) << last[2].why;
  EXPECT_EQ(last[3].verdict, Verdict::kEqual) << last[3].why;
  EXPECT_EQ(last[4].verdict, Verdict::kNotDrawn);
  EXPECT_EQ(last[4].why, "needs `blend something`");
  const auto refused = std::ranges::find(result.shaders, false, &Acceptance::is_expected);
  ASSERT_NE(refused, result.shaders.end());
  EXPECT_FALSE(refused->is_accepted);
  EXPECT_THAT(refused->why, HasSubstr("[undeclared-name, X3004]"));
}

TEST_F(Values, SaysWhatOpenGlRefuses) {
  const FileResult result =
      RunIsolated("[srv 0]\nsize (2d, 4000000000, 4000000000)\n", kFamilies[1]);
  ASSERT_EQ(result.probes.size(), 1u);
  EXPECT_EQ(result.probes[0].verdict, Verdict::kNotDrawn);
}

TEST(Script, ReadsQualifiers) {
  const auto holds = [](const char* text, Model model) {
    Scanner scanner(text);
    return scanner.TakeQualifier(model).holds && scanner.at_end();
  };
  EXPECT_TRUE(holds("(sm>=4 & sm<6)", kModel4));
  EXPECT_FALSE(holds("(sm>=4&sm<6)", kModel6));
  EXPECT_TRUE(holds("(sm<3 | sm>=5.1)", 5));
  EXPECT_TRUE(holds("(!llvmpipe)", 0));
  EXPECT_FALSE(holds("(mvk)", 0));
  EXPECT_TRUE(holds("", 0));
  Scanner scanner("(sm<4.1) rest");
  EXPECT_EQ(scanner.TakeQualifier(0).models, 0b111u);
  EXPECT_EQ(scanner.rest(), "rest");
}

TEST(Script, ReadsBlocksAndWords) {
  const std::vector<Section> sections =
      ReadSections("[a]\none\n% no\n\n[b c(sm<4)]\n1.5 -2 0x10 ; x\n");
  ASSERT_EQ(sections.size(), 2u);
  EXPECT_EQ(sections[0].Text(), "one\n\n");
  EXPECT_EQ(sections[1].header.text, "b c(sm<4)");
  EXPECT_EQ(sections[1].lines[0].number, 6);
  Scanner scanner(sections[1].lines[0].text);
  std::vector<std::uint32_t> words;
  while (const auto word = scanner.TakeWord()) words.push_back(*word);
  EXPECT_THAT(words, ElementsAre(0x3fc00000u, 0xfffffffeu, 16u));
}

}  // namespace
}  // namespace clipc::values
