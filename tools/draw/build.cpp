// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/build.h"

#include <algorithm>
#include <regex>

#include "backend-glsl/program_layout.h"
#include "compiler/compile/check_lowering.h"
#include "compiler/compile/stages.h"
#include "compiler/compile/write_spirv.h"

namespace clipc::draw {
// The text of a shader, and the diagnostics about it.
struct Reading {
  explicit Reading(const BuildOptions& options)
      : profile(Known(ir::ParseProfile(options.profile), "profile", options.profile)),
        source(context, {.path = options.path,
                         .text = {},
                         .include_dirs = options.include_dirs,
                         .defines = options.defines,
                         .shader_model_major = profile.major,
                         .shader_model_minor = profile.minor,
                         .language = options.language}) {}

  void StopAtErrors() const {
    if (diagnostics.has_errors())
      throw DrawError("the shader has errors\n" + source.RenderText(diagnostics, false));
  }

  ir::Profile profile;
  FrontendContext context;
  Source source;
  Diagnostics diagnostics;
};

Tokens Preprocess(const BuildOptions& options) {
  Reading reading(options);
  Tokens tokens = Lex(reading.source, reading.diagnostics);
  reading.StopAtErrors();
  return tokens;
}

struct CheckedShader::State {
  explicit State(const BuildOptions& options_in) : options(options_in), reading(options_in) {}

  BuildOptions options;
  Reading reading;
  ir::Program typed;
  ir::VarId position_input;
};

CheckedShader::CheckedShader(const BuildOptions& options)
    : state_(std::make_unique<State>(options)) {
  Reading& reading = state_->reading;
  CheckOptions check = CheckOptions::For(reading.profile, options.language);
  check.entry = options.entry;
  check.packing = options.packing;
  check.shadow_samplers = options.shadow_samplers;
  check.whole_register_planes = options.lowering == Lowering::kLevel9;
  state_->typed = Front(reading.source, check, reading.diagnostics);
  reading.StopAtErrors();
  state_->position_input = FindPositionInput(
      state_->typed, {options.lowering, options.plane_space, options.position_input},
      reading.diagnostics);
  reading.StopAtErrors();
}

CheckedShader::~CheckedShader() = default;

const ir::Program& CheckedShader::typed() const { return state_->typed; }

namespace {

// The SPIR-V of a program, which has needs of its own; empty where the target has none of it.
std::vector<std::uint32_t> SpirvOf(const ir::Program& typed, LowerOptions options) {
  if (!options.target.Has(glsl::Feature::kSpirv)) return {};
  options.needs = SpirvNeeds(options.target);
  Lowered lowered = Lower(typed, options);
  Diagnostics diagnostics;
  CheckSpirv(lowered.program, lowered.target, {}, diagnostics);
  if (diagnostics.has_errors()) return {};
  Legalize(lowered, options.passes);
  const glsl::LegalStage stage[] = {{lowered.program, lowered.target, {}}};
  const glsl::ProgramLayout layout(stage);
  spirv::Written written = WriteSpirv(lowered, layout.InfoOf(0), {}, SpirvRequest{});
  if (!written.lacks.empty()) throw DrawError("no SPIR-V of " + std::string(written.lacks));
  return std::move(written.words);
}

}  // namespace

Shader CheckedShader::BuildFor(const std::string& target) const {
  const BuildOptions& options = state_->options;
  LowerOptions lower_options{Known(glsl::Target::Parse(target), "target", target), {}, {}};
  lower_options.passes.clip_planes = {options.lowering, options.plane_space,
                                      state_->position_input};
  lower_options.passes.clip_space = options.clip_space;
  lower_options.passes.verify = true;
  Shader shader;
  shader.flips_y = options.clip_space.flip_y;
  shader.typed = state_->typed;
  Lowered lowered = Lower(shader.typed, lower_options);
  Diagnostics diagnostics;
  CheckTarget(lowered, {}, diagnostics);
  if (diagnostics.has_errors())
    throw NotForTarget("not for this target\n" +
                       state_->reading.source.RenderText(diagnostics, false));
  shader.has_int_for_uint = std::ranges::any_of(diagnostics.all(), [](const Diagnostic& reported) {
    return reported.id == DiagId::kTargetUintAsInt;
  });
  Legalize(lowered, lower_options.passes);
  WrittenGlsl written = Write(lowered, {});
  shader.lowered = std::move(lowered.program);
  shader.glsl = std::move(written.glsl);
  shader.info = std::move(written.info);
  shader.spirv = SpirvOf(shader.typed, lower_options);
  return shader;
}

Shader Build(const BuildOptions& options) {
  return CheckedShader(options).BuildFor(options.target);
}

std::string ForOpenGl(const std::string& glsl) {
  std::string text = glsl;
  const auto replace = [&](const char* from, const char* to) {
    text = std::regex_replace(text, std::regex(from), to);
  };
  replace("\\bgl_(BaseVertex|BaseInstance|DrawID)\\b", "gl_$1ARB");
  const bool has_parameters =
      text.find("ARB_shader_draw_parameters") != text.npos || text.find("gl_Base") == text.npos;
  replace("^#version 4[56]0",
          has_parameters ? "#version 450"
                         : "#version 450\n#extension GL_ARB_shader_draw_parameters : require");
  return text;
}

}  // namespace clipc::draw
