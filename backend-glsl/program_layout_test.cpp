// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/program_layout.h"

#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "backend-glsl/test_glsl.h"
#include "legalize/test_shader.h"

namespace clipc::glsl {
namespace {

// A stage that reads a member of a buffer that every stage has, and the buffer b1 of its own.
ir::Program StageThatReads(std::size_t member, const std::string& own, std::string_view target) {
  legalize::TestShader shader;
  const ir::TypeId vector = shader.Vector(ir::Scalar::kFloat, 4);
  shader.AddCbuffer("Frame", {{"tint", vector}, {"light", vector}});
  shader.AddCbuffer(own, {{"color", vector}});
  ir::Builder b = shader.Make();
  const auto member_of = [&](std::uint32_t cbuffer, std::size_t number) {
    return b.Ref(shader.program.cbuffers[ir::CbufferId{cbuffer}].members[number].var);
  };
  shader.Use(member_of(0, member));
  shader.Use(member_of(1, 0));
  shader.Finish();
  return LegalizedFor(std::move(shader.program), *Target::Parse(target));
}

class ProgramLayoutTest : public testing::TestWithParam<const char*> {
 protected:
  const Target target_ = *Target::Parse(GetParam());
  const WriteOptions options_;
  ir::Program first_ = StageThatReads(0, "Camera", GetParam());
  ir::Program second_ = StageThatReads(1, "Material", GetParam());
  const LegalStage stages_[2] = {{first_, target_, options_}, {second_, target_, options_}};
};

TEST_P(ProgramLayoutTest, GivesWhatBothStagesHaveOnePlace) {
  const ProgramLayout layout(stages_);
  const GlslInfo& first = layout.InfoOf(0);
  const GlslInfo& second = layout.InfoOf(1);
  ASSERT_EQ(first.blocks.size(), 2u);
  ASSERT_EQ(second.blocks.size(), 2u);
  EXPECT_TRUE(first.blocks[0].is_shared && second.blocks[0].is_shared);
  EXPECT_EQ(first.blocks[0].name, second.blocks[0].name);
  EXPECT_EQ(first.blocks[0].binding, second.blocks[0].binding);
  EXPECT_FALSE(first.blocks[1].is_shared || second.blocks[1].is_shared);
  EXPECT_NE(first.blocks[1].name, second.blocks[1].name);
  EXPECT_NE(first.blocks[1].binding, second.blocks[1].binding);
}

TEST_P(ProgramLayoutTest, TakesMoreThanTwoStages) {
  ir::Program third = StageThatReads(1, "Camera", GetParam());
  const LegalStage stages[] = {stages_[0], stages_[1], {third, target_, options_}};
  ProgramLayout layout(stages);
  const GlslInfo& first = layout.InfoOf(0);
  const GlslInfo& last = layout.InfoOf(2);
  ASSERT_EQ(last.blocks.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(last.blocks[i].is_shared);
    EXPECT_EQ(first.blocks[i].name, last.blocks[i].name);
    EXPECT_EQ(first.blocks[i].binding, last.blocks[i].binding);
  }
  EXPECT_EQ(layout.InfoOf(1).blocks[0].name, last.blocks[0].name);
  EXPECT_NE(layout.InfoOf(1).blocks[1].binding, last.blocks[1].binding);
  EXPECT_NE(layout.Write(2).find("Frame"), std::string::npos);
}

TEST_P(ProgramLayoutTest, LeavesEachStageToBeWrittenAlone) {
  ProgramLayout forward(stages_), backward(stages_);
  const std::string first = forward.Write(0), second = forward.Write(1);
  EXPECT_EQ(backward.Write(1), second);
  EXPECT_EQ(backward.Write(0), first);
  EXPECT_NE(second.find("Frame"), std::string::npos) << second;
}

INSTANTIATE_TEST_SUITE_P(Targets, ProgramLayoutTest,
                         testing::Values("glsl450", "essl310", "vulkan"));

}  // namespace
}  // namespace clipc::glsl
