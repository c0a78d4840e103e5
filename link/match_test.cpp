// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "link/match.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clipc::link {
namespace {

using testing::ElementsAre;

struct TestOutput {
  const char* semantic;
  std::uint32_t index;
  const char* path;
  int components = 2;
};

// A program that has these outputs and nothing else that Match asks about.
ir::Program ProgramWith(std::initializer_list<TestOutput> outputs) {
  ir::Program program;
  program.entry = program.functions.Add({});
  for (const TestOutput& output : outputs) {
    ir::Var var;
    var.type = program.types.Vector(ir::Scalar::kFloat, output.components);
    var.storage = ir::Storage::kOutput;
    ir::IoVar io;
    io.var = program.vars.Add(std::move(var));
    io.semantic = output.semantic;
    io.index = output.index;
    io.path = output.path;
    io.location = static_cast<std::uint32_t>(program.outputs.size());
    program.outputs.push_back(std::move(io));
  }
  return program;
}

Input InputNamed(const char* name, std::optional<std::uint32_t> location = {},
                 std::uint8_t components = 2) {
  Input input;
  input.name = name;
  input.location = location;
  input.type.components = components;
  input.is_read = true;
  return input;
}

constexpr int kNone = -1;

// For each output the number of the input that it matches, or kNone.
std::vector<int> MatchesOf(const ir::Program& program, std::vector<Input> inputs) {
  Interface pixel;
  pixel.inputs = std::move(inputs);
  Diagnostics diagnostics;
  std::vector<int> inputs_of;
  for (const Matches::Output& output : Match(program, pixel, {}, diagnostics).outputs)
    inputs_of.push_back(output.input ? static_cast<int>(*output.input) : kNone);
  return inputs_of;
}

TEST(Match, BelievesSemanticsMost) {
  const ir::Program program = ProgramWith({{"TEXCOORD", 0, "o.b"}, {"TexCoord", 1, "o.a"}});
  Input input = InputNamed("i_b", 0);
  input.semantic = "TEXCOORD";
  input.index = 1;
  EXPECT_THAT(MatchesOf(program, {input}), ElementsAre(kNone, 0));
}

TEST(Match, KnowsTheNamesOfTools) {
  const ir::Program program =
      ProgramWith({{"NORMAL", 0, "o.n"}, {"TEXCOORD", 0, "o.uv"}, {"TEXCOORD", 1, "o.uv2"}});
  EXPECT_THAT(MatchesOf(program, {InputNamed("in_var_TEXCOORD1"), InputNamed("in_var_NORMAL")}),
              ElementsAre(1, kNone, 0));
  EXPECT_THAT(MatchesOf(program, {InputNamed("vs_TEXCOORD1"), InputNamed("vs_NORMAL0")}),
              ElementsAre(1, kNone, 0));
  EXPECT_THAT(MatchesOf(program, {InputNamed("i_uv2"), InputNamed("i_uv")}),
              ElementsAre(kNone, 1, 0));
  EXPECT_THAT(MatchesOf(program, {InputNamed("v_TexCoord1"), InputNamed("normal")}),
              ElementsAre(1, kNone, 0));
}

TEST(Match, KnowsWordsOfNames) {
  const ir::Program program =
      ProgramWith({{"A", 0, "o.uv"}, {"B", 0, "o.UV"}, {"C", 0, "o.index"}});
  EXPECT_THAT(MatchesOf(program, {InputNamed("fragUV"), InputNamed("inIndex"), InputNamed("i_uv")}),
              ElementsAre(2, 0, 1));
}

TEST(Match, TakesTheLongestName) {
  const ir::Program program = ProgramWith({{"A", 0, "o.uv"}, {"B", 0, "o.light_uv"}});
  EXPECT_THAT(MatchesOf(program, {InputNamed("i_light_uv"), InputNamed("i_uv")}),
              ElementsAre(1, 0));
  EXPECT_THAT(
      MatchesOf(ProgramWith({{"A", 0, "o.uv"}}), {InputNamed("i_light_uv"), InputNamed("i_uv")}),
      ElementsAre(1));
}

TEST(Match, BelievesNamesMoreThanPlaces) {
  const ir::Program program = ProgramWith({{"NORMAL", 0, "o.n"}, {"TEXCOORD", 0, "o.uv"}});
  EXPECT_THAT(MatchesOf(program, {InputNamed("i_uv", 0)}), ElementsAre(kNone, 0));
  EXPECT_THAT(MatchesOf(program, {InputNamed("color", 0)}), ElementsAre(0, kNone));
  EXPECT_THAT(MatchesOf(program, {InputNamed("i_uv", 0), InputNamed("other", 1)}),
              ElementsAre(kNone, 0));
}

TEST(Match, TakesWhatIsLeftInOrder) {
  const ir::Program program = ProgramWith({{"A", 0, "o.a"}, {"B", 0, "o.b"}, {"C", 0, "o.c", 3}});
  EXPECT_THAT(MatchesOf(program, {InputNamed("x"), InputNamed("c", {}, 3), InputNamed("y")}),
              ElementsAre(0, 2, 1));
  EXPECT_THAT(MatchesOf(program, {InputNamed("x"), InputNamed("y")}),
              ElementsAre(kNone, kNone, kNone));
}

TEST(Match, MatchesMatricesAndArraysWhole) {
  const ir::Program program = ProgramWith({{"T", 0, "o.t"}, {"T", 1, "o.t"}, {"T", 2, "o.t"}});
  Input matrix = InputNamed("i_t");
  matrix.type.columns = 3;
  EXPECT_THAT(MatchesOf(program, {matrix}), ElementsAre(0, 0, 0));
  matrix.type.columns = 4;
  EXPECT_THAT(MatchesOf(program, {matrix}), ElementsAre(kNone, kNone, kNone));
  // The indices of two matrices overlap.
  const ir::Program two =
      ProgramWith({{"M", 0, "o.a"}, {"M", 1, "o.a"}, {"M", 1, "o.longer"}, {"M", 2, "o.longer"}});
  matrix.type.columns = 2;
  Input longer = matrix;
  matrix.name = "i_a", longer.name = "i_longer";
  EXPECT_THAT(MatchesOf(two, {matrix, longer}), ElementsAre(0, 0, 1, 1));
  longer.semantic = "M", longer.index = 1;
  EXPECT_THAT(MatchesOf(two, {longer}), ElementsAre(kNone, kNone, 0, 0));
  const ir::Program array = ProgramWith({{"W", 0, "o.w[0]"}, {"W", 1, "o.w[1]"}});
  EXPECT_THAT(MatchesOf(array, {InputNamed("i_w_1_"), InputNamed("i_w_0_")}), ElementsAre(1, 0));
  Input whole = InputNamed("i_w");
  whole.type.dimensions = {2};
  EXPECT_THAT(MatchesOf(array, {whole}), ElementsAre(0, 0));
}

TEST(Match, LeavesOutWhatIsNotRead) {
  const ir::Program program = ProgramWith({{"A", 0, "o.a"}});
  Interface pixel;
  pixel.inputs.push_back(InputNamed("i_a", 0));
  pixel.inputs[0].is_read = false;
  Diagnostics diagnostics;
  EXPECT_FALSE(Match(program, pixel, {}, diagnostics).outputs[0].input);
  EXPECT_TRUE(Match(program, pixel, {.is_vulkan = true}, diagnostics).outputs[0].input);
  EXPECT_FALSE(diagnostics.has_errors());
}

}  // namespace
}  // namespace clipc::link
