// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "pixel/meet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clipc::pixel {
namespace {

using testing::ElementsAre;

struct TestOutput {
  const char* semantic;
  std::uint32_t index;
  const char* path;
  int components = 2;
};

// A program that has these outputs and nothing else that Meet asks about.
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
  input.shape.components = components;
  input.is_read = true;
  return input;
}

constexpr int kNone = -1;

// For each output the number of the input that it meets, or kNone.
std::vector<int> Met(const ir::Program& program, std::vector<Input> inputs) {
  Interface pixel;
  pixel.inputs = std::move(inputs);
  Diagnostics diagnostics;
  std::vector<int> met;
  for (const Meeting::Output& output : Meet(program, pixel, {}, diagnostics).outputs)
    met.push_back(output.input ? static_cast<int>(*output.input) : kNone);
  return met;
}

TEST(Meet, BelievesSemanticsMost) {
  const ir::Program program = ProgramWith({{"TEXCOORD", 0, "o.b"}, {"TexCoord", 1, "o.a"}});
  Input input = InputNamed("i_b", 0);
  input.semantic = "TEXCOORD";
  input.index = 1;
  EXPECT_THAT(Met(program, {input}), ElementsAre(kNone, 0));
}

TEST(Meet, KnowsTheNamesOfTools) {
  const ir::Program program =
      ProgramWith({{"NORMAL", 0, "o.n"}, {"TEXCOORD", 0, "o.uv"}, {"TEXCOORD", 1, "o.uv2"}});
  EXPECT_THAT(Met(program, {InputNamed("in_var_TEXCOORD1"), InputNamed("in_var_NORMAL")}),
              ElementsAre(1, kNone, 0));
  EXPECT_THAT(Met(program, {InputNamed("vs_TEXCOORD1"), InputNamed("vs_NORMAL0")}),
              ElementsAre(1, kNone, 0));
  EXPECT_THAT(Met(program, {InputNamed("i_uv2"), InputNamed("i_uv")}), ElementsAre(kNone, 1, 0));
  EXPECT_THAT(Met(program, {InputNamed("v_TexCoord1"), InputNamed("normal")}),
              ElementsAre(1, kNone, 0));
}

TEST(Meet, KnowsWordsOfNames) {
  const ir::Program program =
      ProgramWith({{"A", 0, "o.uv"}, {"B", 0, "o.UV"}, {"C", 0, "o.index"}});
  EXPECT_THAT(Met(program, {InputNamed("fragUV"), InputNamed("inIndex"), InputNamed("i_uv")}),
              ElementsAre(2, 0, 1));
}

TEST(Meet, TakesTheLongestName) {
  const ir::Program program = ProgramWith({{"A", 0, "o.uv"}, {"B", 0, "o.light_uv"}});
  EXPECT_THAT(Met(program, {InputNamed("i_light_uv"), InputNamed("i_uv")}), ElementsAre(1, 0));
  EXPECT_THAT(Met(ProgramWith({{"A", 0, "o.uv"}}), {InputNamed("i_light_uv"), InputNamed("i_uv")}),
              ElementsAre(1));
}

TEST(Meet, BelievesNamesMoreThanPlaces) {
  const ir::Program program = ProgramWith({{"NORMAL", 0, "o.n"}, {"TEXCOORD", 0, "o.uv"}});
  EXPECT_THAT(Met(program, {InputNamed("i_uv", 0)}), ElementsAre(kNone, 0));
  EXPECT_THAT(Met(program, {InputNamed("color", 0)}), ElementsAre(0, kNone));
  EXPECT_THAT(Met(program, {InputNamed("i_uv", 0), InputNamed("other", 1)}), ElementsAre(kNone, 0));
}

TEST(Meet, TakesWhatIsLeftInOrder) {
  const ir::Program program = ProgramWith({{"A", 0, "o.a"}, {"B", 0, "o.b"}, {"C", 0, "o.c", 3}});
  EXPECT_THAT(Met(program, {InputNamed("x"), InputNamed("c", {}, 3), InputNamed("y")}),
              ElementsAre(0, 2, 1));
  EXPECT_THAT(Met(program, {InputNamed("x"), InputNamed("y")}), ElementsAre(kNone, kNone, kNone));
}

TEST(Meet, MeetsMatricesAndArraysWhole) {
  const ir::Program program = ProgramWith({{"T", 0, "o.t"}, {"T", 1, "o.t"}, {"T", 2, "o.t"}});
  Input matrix = InputNamed("i_t");
  matrix.shape.columns = 3;
  EXPECT_THAT(Met(program, {matrix}), ElementsAre(0, 0, 0));
  matrix.shape.columns = 4;
  EXPECT_THAT(Met(program, {matrix}), ElementsAre(kNone, kNone, kNone));
  // The indices of two matrices overlap.
  const ir::Program two =
      ProgramWith({{"M", 0, "o.a"}, {"M", 1, "o.a"}, {"M", 1, "o.longer"}, {"M", 2, "o.longer"}});
  matrix.shape.columns = 2;
  Input longer = matrix;
  matrix.name = "i_a", longer.name = "i_longer";
  EXPECT_THAT(Met(two, {matrix, longer}), ElementsAre(0, 0, 1, 1));
  longer.semantic = "M", longer.index = 1;
  EXPECT_THAT(Met(two, {longer}), ElementsAre(kNone, kNone, 0, 0));
  const ir::Program array = ProgramWith({{"W", 0, "o.w[0]"}, {"W", 1, "o.w[1]"}});
  EXPECT_THAT(Met(array, {InputNamed("i_w_1_"), InputNamed("i_w_0_")}), ElementsAre(1, 0));
  Input whole = InputNamed("i_w");
  whole.shape.dimensions = {2};
  EXPECT_THAT(Met(array, {whole}), ElementsAre(0, 0));
}

TEST(Meet, LeavesOutWhatIsNotRead) {
  const ir::Program program = ProgramWith({{"A", 0, "o.a"}});
  Interface pixel;
  pixel.inputs.push_back(InputNamed("i_a", 0));
  pixel.inputs[0].is_read = false;
  Diagnostics diagnostics;
  EXPECT_FALSE(Meet(program, pixel, {}, diagnostics).outputs[0].input);
  EXPECT_TRUE(Meet(program, pixel, {.is_vulkan = true}, diagnostics).outputs[0].input);
  EXPECT_FALSE(diagnostics.has_errors());
}

}  // namespace
}  // namespace clipc::pixel
