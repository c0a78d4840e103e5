// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/pipeline.h"

#include <array>
#include <bit>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ir/access.h"
#include "ir/builder.h"
#include "ir/evaluate.h"
#include "ir/print.h"
#include "ir/test_program.h"

namespace clipc::passes {
namespace {

using namespace ir;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::uint32_t kPlanesOffset = 64;  // in TestProgram's buffer, after its matrix

// [clipplanes(planes[0], planes[1])] float4 entry(float4 p) : SV_Position { return p; }
Program TwoPlanes() {
  TestProgram program;
  program.Append({program.Return(program.build.Ref(program.parameter))});
  for (std::uint32_t i = 0; i < 2; ++i) {
    program.clip_planes.push_back({.value = program.build.At(program.build.Ref(program.planes), i),
                                   .span = {},
                                   .text = "planes[" + std::to_string(i) + "]",
                                   .cbuffer = program.camera,
                                   .offset = kPlanesOffset + 16 * i,
                                   .whole_register = true});
  }
  return program;
}

Program Lowered(Program program, PipelineOptions options) {
  options.verify = true;
  RunPipeline(program, options);
  return program;
}

std::string MainOf(const Program& program) {
  const std::string text = Print(program);
  return text.substr(text.find("void main("));
}

// The values that `main` writes for a vertex, output by output.
std::vector<std::vector<float>> OutputsOf(const Program& program, std::array<float, 4> vertex) {
  EvalInputs inputs;
  inputs.values.resize(1);
  for (int i = 0; i < 4; ++i) inputs.values[0][i] = std::bit_cast<std::uint32_t>(vertex[i]);
  std::vector<std::uint8_t>& bytes = inputs.cbuffers.emplace_back(kPlanesOffset);
  for (const float value : {1.0f, 0.0f, 0.0f, -0.5f, 0.0f, 2.0f, -1.0f, 0.25f}) {
    for (int i = 0; i < 4; ++i)
      bytes.push_back(static_cast<std::uint8_t>(std::bit_cast<std::uint32_t>(value) >> 8 * i));
  }
  const EvalResult result = RunMain(program, inputs);
  EXPECT_TRUE(result) << result.error;
  std::vector<std::vector<float>> all;
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    const Type& type = program.types[program.vars[program.outputs[i].var].type];
    const std::uint32_t count = type.kind == TypeKind::kArray ? type.count : type.Components();
    std::vector<float>& values = all.emplace_back();
    for (std::uint32_t k = 0; k < count; ++k)
      values.push_back(static_cast<float>(result.outputs.numbers[i][k]));
  }
  return all;
}

TEST(Pipeline, ClipDistances) {
  const Program program = Lowered(TwoPlanes(), {});
  EXPECT_EQ(program.form, Form::kInlined);
  EXPECT_THAT(OutputsOf(program, {3, 5, 7, 2}),
              ElementsAre(ElementsAre(3, 5, 7, 2), ElementsAre(3 - 1, 10 - 7 + 0.5f)));
  EXPECT_EQ(program.outputs[1].builtin, Builtin::kClipDistance);
  EXPECT_EQ(program.types.Name(program.vars[program.outputs[1].var].type), "float[2]");
  EXPECT_FALSE(program.clip_planes[0].value);
  EXPECT_EQ(program.clip_planes[1].text, "planes[1]");
}

TEST(Pipeline, ClipDistancesAreThoseOfTheHlslPosition) {
  PipelineOptions options;
  options.clip_space = {.negative_one_to_one = true, .flip_y = true};
  EXPECT_THAT(OutputsOf(Lowered(TwoPlanes(), options), {3, 5, 7, 2}),
              ElementsAre(ElementsAre(3, -5, 14 - 2, 2), ElementsAre(2, 3.5f)));
}

TEST(Pipeline, Xyw1LeavesTheDepthOut) {
  PipelineOptions options;
  options.clip_planes.space = PlaneSpace::kXyw1;
  options.clip_space = {.negative_one_to_one = true, .flip_y = true};
  // The distances are those of the HLSL position: 3 - 0.5 * 1 and 2 * 5 - 2 + 0.25 * 1.
  EXPECT_THAT(OutputsOf(Lowered(TwoPlanes(), options), {3, 5, 7, 2}),
              ElementsAre(ElementsAre(3, -5, 14 - 2, 2), ElementsAre(2.5f, 8.25f)));
}

// The program of TwoPlanes, but its shader doubles the position.
Program TwoPlanesAndADoubledPosition() {
  Program program = TwoPlanes();
  Builder b(program);
  const ExprId position = b.Ref(program.outputs[0].var), twice = b.Ref(program.outputs[0].var);
  const TypeId type = b.TypeOf(position);
  AppendToBody(program, program.main,
               std::array{b.Eval(b.AssignTo(
                   position, b.BinaryOf(BinaryOp::kMul, twice, b.SplatTo(type, b.Float(2)))))});
  return program;
}

TEST(Pipeline, ObjectSpaceTakesTheVertexAsItComesIn) {
  Program program = TwoPlanesAndADoubledPosition();
  PipelineOptions options;
  options.clip_planes.space = PlaneSpace::kObject;
  options.clip_planes.position_input = program.inputs[0].var;
  EXPECT_THAT(OutputsOf(Lowered(program, options), {3, 5, 7, 2}),
              ElementsAre(ElementsAre(6, 10, 14, 4), ElementsAre(3 - 1, 10 - 7 + 0.5f)));
  EXPECT_THAT(OutputsOf(Lowered(program, {}), {3, 5, 7, 2}),
              ElementsAre(ElementsAre(6, 10, 14, 4), ElementsAre(6 - 2, 20 - 14 + 1)));
}

TEST(Pipeline, ClipSpaceOptionsAreIndependent) {
  PipelineOptions options;
  options.clip_planes.lowering = Lowering::kNone;
  EXPECT_THAT(OutputsOf(Lowered(TwoPlanes(), options), {3, 5, 7, 2}),
              ElementsAre(ElementsAre(3, 5, 7, 2)));
  options.clip_space = {.negative_one_to_one = true, .flip_y = false};
  EXPECT_THAT(OutputsOf(Lowered(TwoPlanes(), options), {3, 5, 7, 2}),
              ElementsAre(ElementsAre(3, 5, 12, 2)));
  options.clip_space = {.negative_one_to_one = false, .flip_y = true};
  EXPECT_THAT(OutputsOf(Lowered(TwoPlanes(), options), {3, 5, 7, 2}),
              ElementsAre(ElementsAre(3, -5, 7, 2)));
}

TEST(Pipeline, Level9LeavesThePlanesToTheTable) {
  PipelineOptions options;
  options.clip_planes.lowering = Lowering::kLevel9;
  const Program program = Lowered(TwoPlanes(), options);
  EXPECT_EQ(program.outputs.size(), 1u);
  EXPECT_EQ(program.clip_planes.size(), 2u);
  EXPECT_THAT(MainOf(program), Not(HasSubstr("dot")));
}

TEST(Pipeline, Level9ClipVertexIsTheHlslPosition) {
  PipelineOptions options;
  options.clip_planes = {.lowering = Lowering::kLevel9, .write_clip_vertex = true};
  options.clip_space = {.negative_one_to_one = true, .flip_y = true};
  const Program program = Lowered(TwoPlanes(), options);
  EXPECT_EQ(program.outputs[1].builtin, Builtin::kClipVertex);
  EXPECT_THAT(OutputsOf(program, {3, 5, 7, 2}),
              ElementsAre(ElementsAre(3, -5, 12, 2), ElementsAre(3, 5, 7, 2)));
}

TEST(Pipeline, NearPlaneIsTheDepth) {
  Program one = TwoPlanes();
  one.clip_planes.erase(one.clip_planes.begin());
  PipelineOptions options;
  options.clip_planes.lowering = Lowering::kNearPlane;
  EXPECT_THAT(OutputsOf(Lowered(one, options), {3, 5, 7, 2}),
              ElementsAre(ElementsAre(3, 5, 3.5f, 2)));
  options.clip_space = {.negative_one_to_one = true, .flip_y = true};
  EXPECT_THAT(OutputsOf(Lowered(one, options), {3, 5, 7, 2}),
              ElementsAre(ElementsAre(3, -5, 2 * 3.5f - 2, 2)));
}

TEST(Pipeline, DiscardWritesTheDistancesAsVectors) {
  PipelineOptions options;
  options.clip_planes.lowering = Lowering::kDiscard;
  options.clip_space = {.negative_one_to_one = true, .flip_y = true};
  const Program two = Lowered(TwoPlanes(), options);
  EXPECT_THAT(OutputsOf(two, {3, 5, 7, 2}),
              ElementsAre(ElementsAre(3, -5, 12, 2), ElementsAre(2, 3.5f)));
  EXPECT_EQ(two.outputs[1].semantic, kClipPlaneDistance);

  Program five = TwoPlanes();
  for (int i = 0; i < 3; ++i) {
    ClipPlane again = five.clip_planes[1];
    again.value = Clone(five, again.value);
    five.clip_planes.push_back(again);
  }
  EXPECT_THAT(
      OutputsOf(Lowered(five, options), {3, 5, 7, 2}),
      ElementsAre(ElementsAre(3, -5, 12, 2), ElementsAre(2, 3.5f, 3.5f, 3.5f), ElementsAre(3.5f)));
}

TEST(Pipeline, AShaderWithoutPlanesOrPositionStaysAsItIs) {
  Program program = TwoPlanes();
  program.clip_planes.clear();
  program.outputs[0].builtin = Builtin::kNone;
  PipelineOptions options;
  options.clip_space = {.negative_one_to_one = true, .flip_y = true};
  const std::string before = Print(program);
  for (const Lowering lowering : {Lowering::kClipDistance, Lowering::kLevel9, Lowering::kNone,
                                  Lowering::kNearPlane, Lowering::kDiscard}) {
    options.clip_planes = {.lowering = lowering, .write_clip_vertex = true};
    options.stop_after = "adjust-clip-space";
    EXPECT_EQ(MainOf(Lowered(program, options)), MainOf(program));
  }
  EXPECT_EQ(Print(program), before);
}

TEST(Pipeline, StopsAndDumpsAfterAPass) {
  std::vector<std::string> seen;
  PipelineOptions options;
  options.clip_space.flip_y = true;
  options.after_pass = [&](std::string_view pass, const Program& program) {
    seen.push_back(std::string(pass) +
                   (MainOf(program).find('-') == std::string::npos ? "" : " flipped"));
    return true;
  };
  Lowered(TwoPlanes(), options);
  std::vector<std::string> expected;
  bool is_flipped = false;
  for (const std::string_view pass : PassNames()) {
    is_flipped = is_flipped || pass == "adjust-clip-space";
    expected.push_back(std::string(pass) + (is_flipped ? " flipped" : ""));
  }
  EXPECT_EQ(seen, expected);
  seen.clear();
  options.stop_after = "lower-clip-planes";
  EXPECT_EQ(Lowered(TwoPlanes(), options).form, Form::kNoClipPlanes);
  EXPECT_THAT(seen, ElementsAre("lower-clip-planes"));
  options.stop_after.clear();
  options.after_pass = [](std::string_view pass, const Program&) { return pass != "inline-entry"; };
  Program stopped = TwoPlanes();
  EXPECT_FALSE(RunPipeline(stopped, options));
  EXPECT_EQ(stopped.form, Form::kInlined);
}

TEST(Pipeline, HasAFolderOfTestsForEachPass) {
  for (const std::string_view pass : PassNames())
    EXPECT_TRUE(std::filesystem::is_directory("testdata/passes/" + std::string(pass))) << pass;
}

TEST(PipelineDeathTest, PassesWantTheirForms) {
  Program program = TwoPlanes();
  EXPECT_DEATH(AdjustClipSpace(program, {}), "kNoClipPlanes");
  LowerClipPlanes(program, {});
  EXPECT_DEATH(LowerClipPlanes(program, {}), "kResolved");
}

}  // namespace
}  // namespace clipc::passes
