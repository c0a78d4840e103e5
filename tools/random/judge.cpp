// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/judge.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <fstream>
#include <iterator>

#include <spirv-tools/libspirv.hpp>

#include "backend-glsl/target.h"
#include "compiler/compile/validate.h"
#include "tools/draw/build.h"
#include "tools/draw/compare.h"
#include "tools/draw/draw_call.h"
#include "tools/draw/opengl/compare.h"
#include "tools/draw/opengl/domain.h"
#include "tools/draw/vulkan/compare.h"
#include "tools/draw/vulkan/glslang.h"
#include "tools/random/check_layout.h"

namespace clipc::random {
namespace {

using draw::BuildOptions;
using draw::Comparison;
using draw::Shader;

// An exception that ends the judgement with a verdict.
struct Found {
  Verdict verdict;
};

[[noreturn]] void Report(Fault fault, const std::string& target, const std::string& what) {
  throw Found{{fault, target, what}};
}

BuildOptions OptionsOf(const Program& program, const std::string& path) {
  BuildOptions build;
  build.path = path;
  build.profile = program.profile;
  if (program.row_major) build.packing = MatrixPacking::kRowMajor;
  build.lowering = draw::Known(ParseLowering(program.lowering), "lowering", program.lowering);
  build.plane_space =
      draw::Known(ParsePlaneSpace(program.plane_space), "plane space", program.plane_space);
  build.position_input = program.position_input;
  build.clip_space = {program.negative_one_to_one, program.flip_y};
  return build;
}

draw::RandomOptions RandomOptionsOf(const Program& program) {
  // Texels that differ would make the level that a driver takes count.
  return {.seed = program.inputs,
          .vertices = program.vertices,
          .constant_textures = true,
          .quarters = true};
}

draw::Tolerance ToleranceOf(const Program& program) {
  return {.ulps = program.is_soft ? double{kSoftUlps} : -1};
}

std::string Words(const Comparison& comparison) {
  std::string text;
  for (const std::string& mistake : comparison.mistakes) text += mistake + "\n";
  return text;
}

// What spirv-val says of a module; empty if nothing is wrong.
std::string ProblemOf(const std::vector<std::uint32_t>& words) {
  std::string problem;
  spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_1);
  tools.SetMessageConsumer(
      [&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
        if (problem.empty()) problem = std::string("spirv-val: ") + message;
      });
  if (tools.Validate(words)) return "";
  return problem.empty() ? "spirv-val refuses it" : problem;
}

// What is wrong with the SPIR-V of the shader, glslang's and clipc's own; empty if nothing is.
std::string SpirvProblem(const Shader& shader) {
  std::string problem;
  try {
    problem = ProblemOf(draw::vulkan::SpirvOfGlsl(shader.glsl, shader.typed.stage));
  } catch (const draw::DrawError& error) {
    problem = error.what();
  }
  if (!problem.empty()) return problem;
  return ProblemOf(shader.spirv);
}

}  // namespace

std::string_view NameOf(Fault fault) {
  constexpr std::string_view kNames[] = {"none",  "refused", "layout", "undefined", "invalid",
                                         "wrong", "driver",  "crash",  "hang"};
  return kNames[static_cast<std::size_t>(fault)];
}

std::string Verdict::Key() const {
  std::string key(NameOf(fault));
  if (fault == Fault::kWrong || fault == Fault::kHang) return key;
  // The words of the message, without the names and numbers of the program.
  key += ": ";
  bool quoted = false;
  const std::size_t error = what.find("error: ");
  const std::size_t begin = error == std::string::npos ? 0 : error + std::size("error: ") - 1;
  for (const char letter : what.substr(begin, what.find('\n', begin) - begin)) {
    if (letter == '`' || letter == '\'') quoted = !quoted;
    if (!quoted && (std::isalpha(static_cast<unsigned char>(letter)) || letter == ' '))
      key += letter;
  }
  return key.substr(0, 90);
}

struct Judge::State {
  explicit State(JudgeOptions options_in) : options(std::move(options_in)) {}

  void Step(const std::string& name) const {
    if (options.before_step) options.before_step(name);
  }

  bool Looks(Fault fault, const std::string& target) const {
    return !only || (only->fault == fault && (only->target == target || only->target.empty())) ||
           only->fault == Fault::kCrash || only->fault == Fault::kHang;
  }

  void Run(const Program& program);
  void CheckTarget(const draw::CheckedShader& checked, const std::string& target);
  void Draw(const Program& program, const draw::CheckedShader& checked, const std::string& target);
  void DrawSomeOpenGl(const Program& program, const draw::CheckedShader& checked);
  Comparison Compare(const std::string& target, const draw::Trial& trial);
  harness::OpenGl& OpenGl();

  JudgeOptions options;
  std::optional<Verdict> only;
  std::string path;
  std::optional<harness::OpenGl> opengl;
  std::optional<draw::vulkan::Runner> vulkan;
};

void Judge::State::Run(const Program& program) {
  path = options.scratch + "/program.hlsl";
  std::ofstream(path) << program.text;
  const BuildOptions build = OptionsOf(program, path);
  Step("check");
  std::optional<draw::CheckedShader> checked;
  try {
    checked.emplace(build);
  } catch (const draw::DrawError& error) {
    const std::string what = error.what();
    Report(Fault::kRefused, "", what.substr(what.find('\n') + 1));
  }
  if (Looks(Fault::kLayout, "")) {
    Step("layout");
    const std::string problem = LayoutProblem(program, checked->typed());
    if (!problem.empty()) Report(Fault::kLayout, "", problem);
  }
  for (const std::string_view name : glsl::Target::Names()) {
    const std::string target(name);
    if (Looks(Fault::kInvalid, target)) CheckTarget(*checked, target);
  }
  if (!options.draws) return;
  if (only && !only->target.empty()) return Draw(program, *checked, only->target);
  Draw(program, *checked, "vulkan");
  DrawSomeOpenGl(program, *checked);
}

void Judge::State::CheckTarget(const draw::CheckedShader& checked, const std::string& target) {
  Step("compile for " + target);
  try {
    const Shader shader = checked.BuildFor(target);
    Step("validate " + target);
    const glsl::Target parsed = *glsl::Target::Parse(target);
    const std::vector<std::string> problems = Validate(shader.glsl, parsed, shader.typed.stage);
    if (!problems.empty() && UnknownToValidator(shader.glsl, parsed).empty())
      Report(Fault::kInvalid, target, problems[0] + "\n" + shader.glsl);
    if (!parsed.IsVulkan()) return;
    Step("SPIR-V");
    const std::string problem = SpirvProblem(shader);
    if (!problem.empty()) Report(Fault::kInvalid, target, problem + "\n" + shader.glsl);
  } catch (const draw::NotForTarget&) {
    return;  // the target lacks something, and clipc said so
  }
}

void Judge::State::DrawSomeOpenGl(const Program& program, const draw::CheckedShader& checked) {
  const auto names = glsl::Target::Names();
  const std::size_t count = names.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string target(names[(program.target + i) % count]);
    if (target == "vulkan" || target.starts_with("webgl")) continue;  // not OpenGL, or for browsers
    try {
      return Draw(program, checked, target);
    } catch (const draw::NotForTarget&) {
      continue;
    }
  }
}

void Judge::State::Draw(const Program& program, const draw::CheckedShader& checked,
                        const std::string& target) {
  const Shader shader = checked.BuildFor(target);
  // Programs have integers of all 32 bits.
  if (shader.has_int_for_uint) throw draw::NotForTarget("values from 2^31 on are negative");
  draw::RandomOptions random = RandomOptionsOf(program);
  draw::ChooseDraw(shader, random);
  Step("evaluate for " + target);
  draw::RandomInputs inputs = draw::MakeRandomInputs(shader.typed, random);
  if (clipc::InfoOf(program.stage).reads_patches)
    inputs.points = draw::PointsOf(OpenGl(), shader, inputs);
  std::vector<draw::Expected> expected;
  try {
    expected = draw::MakeExpected(shader, OptionsOf(program, path), inputs);
  } catch (const draw::DrawError& error) {
    Report(Fault::kRefused, target, error.what());
  }
  for (const draw::Expected& output : expected) {
    if (std::ranges::find(output.open, true) != output.open.end())
      Report(Fault::kUndefined, target, "`" + output.name + "` has an undefined value");
  }
  Step("draw " + target);
  try {
    const Comparison found =
        Compare(target, {shader, expected, inputs, random, ToleranceOf(program)});
    if (found.wrong > 0) Report(Fault::kWrong, target, Words(found) + shader.glsl);
  } catch (const draw::DrawError& error) {
    Report(Fault::kDriver, target, error.what());
  }
}

Comparison Judge::State::Compare(const std::string& target, const draw::Trial& trial) {
  if (target == "vulkan") {
    if (!vulkan) vulkan.emplace();
    return draw::vulkan::CompareWithVulkan(*vulkan, trial);
  }
  return draw::CompareWithOpenGl(OpenGl(), trial);
}

harness::OpenGl& Judge::State::OpenGl() {
  if (!opengl) opengl.emplace();
  return *opengl;
}

Judge::Judge(JudgeOptions options) : state_(std::make_unique<State>(std::move(options))) {}
Judge::~Judge() = default;

Verdict Judge::operator()(const Program& program, const std::optional<Verdict>& only) {
  state_->only = only;
  Verdict verdict;
  try {
    state_->Run(program);
  } catch (Found& found) {
    verdict = std::move(found.verdict);
  } catch (const draw::NotForTarget&) {
    verdict = {};
  } catch (const std::exception& error) {
    verdict = {Fault::kDriver, "", error.what()};
  }
  return verdict;
}

}  // namespace clipc::random
