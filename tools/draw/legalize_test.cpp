// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ir/evaluate.h"
#include "ir/scalar.h"
#include "tools/draw/build.h"
#include "tools/draw/random_inputs.h"

// The program that the writer prints means the same as the program before the legalising passes:
// the evaluator runs both, and every output has the same bits.
namespace clipc::draw {
namespace {

// The values of the outputs. The bits of a NaN mean nothing: all are one.
std::vector<ir::IoBits> Outputs(const ir::Program& program, const RandomInputs& inputs,
                                std::size_t vertex) {
  Buffers buffers = inputs.buffers;
  const auto use = [&](const ir::ObjectRequest& request, std::span<std::uint64_t> result) {
    inputs.UseObject(program, buffers, request, 0, result);
  };
  const ir::EvalResult result = ir::RunMain(program, {.values = inputs.vertices[vertex],
                                                      .cbuffers = inputs.cbuffers,
                                                      .read_object = use,
                                                      .start = {}});
  EXPECT_TRUE(result) << result.error;
  std::vector<ir::IoBits> values = result.outputs.values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ir::Scalar kind = program.types[program.vars[program.outputs[i].var].type].scalar;
    for (std::uint64_t& bits : values[i]) {
      if (ir::BaseOf(kind) == ir::Scalar::kFloat && std::isnan(ir::FloatOf(bits)))
        bits = ir::BitsOf(std::numeric_limits<float>::quiet_NaN());
    }
  }
  return values;
}

// Expects the same outputs from the program with and without the legalising passes. Returns false
// if the target cannot express the shader or a test cannot draw with it.
bool ExpectSame(const std::string& path, const std::string& target) {
  BuildOptions options;
  options.path = path;
  options.target = target;
  options.include_dirs = {"testdata/draw/inputs"};
  Shader shader;
  RandomInputs inputs;
  try {
    shader = Build(options);
    inputs = MakeRandomInputs(shader.typed, {});
  } catch (const DrawError&) {
    return false;
  }
  EXPECT_EQ(shader.lowered.form, ir::Form::kAddressed);
  ir::Program plain = shader.typed;
  passes::PipelineOptions passes;
  passes.clip_planes.write_clip_vertex = false;
  passes::RunPipeline(plain, passes);
  for (std::size_t vertex = 0; vertex < inputs.vertices.size(); ++vertex) {
    SCOPED_TRACE(::testing::Message() << path << " for " << target << ", vertex " << vertex);
    EXPECT_EQ(Outputs(plain, inputs, vertex), Outputs(shader.lowered, inputs, vertex));
  }
  return true;
}

TEST(Legalize, KeepsWhatShadersMean) {
  int compared = 0;
  for (const char* folder : {"testdata/draw", "testdata/glsl"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.path().extension() != ".hlsl") continue;
      for (const char* target : {"glsl120", "glsl450", "essl300"}) {
        compared += ExpectSame(entry.path().string(), target) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace clipc::draw
