// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/batch/permutations.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/batch/macro_memo.h"

namespace clipc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> ValuesOf(const std::string& list) {
  std::vector<std::string> defines = {"A=" + list}, values;
  for (const MacroAxis& axis : TakeAxes(defines)) {
    for (const auto& value : axis.values) values.push_back(*value);
  }
  EXPECT_EQ(defines.empty(), !values.empty());
  return values;
}

TEST(Permutations, ListsOfValues) {
  EXPECT_THAT(ValuesOf("{0,1}"), ElementsAre("0", "1"));
  EXPECT_THAT(ValuesOf("{}"), ElementsAre(""));
  EXPECT_THAT(ValuesOf("{,a}"), ElementsAre("", "a"));
  EXPECT_THAT(ValuesOf("{f(1,2),{3,4},v[5,6]}"), ElementsAre("f(1,2)", "{3,4}", "v[5,6]"));
  EXPECT_THAT(ValuesOf("{{0,1}}"), ElementsAre("{0,1}"));
  for (const char* text : {"", "1", "{", "}", "{1", "1}", "{1},{2}", "{1}+{2}"})
    EXPECT_THAT(ValuesOf(text), IsEmpty()) << text;
}

TEST(Permutations, TheLastAxisVariesFirst) {
  ShaderGroup group;
  group.source = "a/water.hlsl";
  group.name = "water";
  group.axes = {{"A", {"0", "1"}}, {"B", {std::nullopt, "x y", "z"}}, {"ONE", {"1"}}};
  ASSERT_EQ(group.Count(), 6u);
  EXPECT_THAT(DefinesOf(group, 0), ElementsAre("A=0", "ONE=1"));
  EXPECT_THAT(DefinesOf(group, 4), ElementsAre("A=1", "B=x y", "ONE=1"));
  EXPECT_EQ(FileNameOf(group, 0), "water.A0");
  EXPECT_EQ(FileNameOf(group, 4), "water.A1.Bx_y");
  EXPECT_EQ(TitleOf(group, 5), "a/water.hlsl A=1 B=z ONE=1");
  for (int i = 0; i < 70; ++i) group.axes.push_back({"C", {"0", "1"}});
  EXPECT_GT(group.Count(), kMaxPermutations);
}

TEST(MacroMemo, FindsPermutationsWithTheSameAnswers) {
  MacroMemo memo({"A", "B", "F(x)"});
  memo.Add({"1", "2", "f"}, {"A", "Z"}, 7);
  EXPECT_EQ(memo.Find({"1", "9", "f"}), 7u);
  EXPECT_EQ(memo.Find({"2", "2", "f"}), std::nullopt);
  EXPECT_EQ(memo.Find({"1", "2", "g"}), std::nullopt) << "a macro with arguments always counts";
  memo.Add({"2", "2", "f"}, {"A", "B"}, 8);
  EXPECT_EQ(memo.Find({"2", "2", "f"}), 8u);
  EXPECT_EQ(memo.Find({"2", "3", "f"}), std::nullopt);
  // "1" and "11" are not "11" and "1".
  MacroMemo two({"A", "B"});
  two.Add({"1", "11"}, {"A", "B"}, 1);
  EXPECT_EQ(two.Find({"11", "1"}), std::nullopt);
}

}  // namespace
}  // namespace clipc
