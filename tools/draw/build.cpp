// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/build.h"

#include <regex>

#include "compiler/check_lowering.h"
#include "compiler/stages.h"

namespace clipc::draw {
namespace {

// The text of a shader, and what is said about it.
struct Reading {
  explicit Reading(const BuildOptions& options)
      : profile(Known(ir::ParseProfile(options.profile), "profile", options.profile)),
        source(context, {.path = options.path,
                         .text = {},
                         .include_dirs = options.include_dirs,
                         .defines = options.defines,
                         .shader_model_major = profile.major,
                         .shader_model_minor = profile.minor}) {}

  template <typename Error>
  void StopAtErrors(const std::string& what) const {
    if (diagnostics.has_errors()) throw Error(what + "\n" + source.RenderText(diagnostics, false));
  }

  ir::Profile profile;
  FrontendContext context;
  Source source;
  Diagnostics diagnostics;
};

}  // namespace

Tokens Preprocess(const BuildOptions& options) {
  Reading reading(options);
  Tokens tokens = Lex(reading.source, reading.diagnostics);
  reading.StopAtErrors<DrawError>("the shader has errors");
  return tokens;
}

Shader Build(const BuildOptions& options) {
  Reading reading(options);
  LowerSettings settings{Known(glsl::Target::Parse(options.target), "target", options.target), {}};
  Shader shader;
  shader.typed = Front(
      reading.source,
      {reading.profile, options.entry, options.packing, options.lowering == Lowering::kLevel9},
      reading.diagnostics);
  reading.StopAtErrors<DrawError>("the shader has errors");
  settings.passes.clip_planes = {
      options.lowering, options.plane_space,
      CheckLowering(shader.typed, {options.lowering, options.plane_space, options.position_input},
                    reading.diagnostics)};
  reading.StopAtErrors<DrawError>("the shader has errors");
  settings.passes.clip_space = options.clip_space;
  settings.passes.verify = true;
  Lowered lowered = Lower(shader.typed, settings);
  CheckTarget(lowered, {}, reading.diagnostics);
  reading.StopAtErrors<NotForTarget>("not for this target");
  Legalize(lowered, settings.passes);
  Written written = Write(lowered, {});
  shader.lowered = std::move(lowered.program);
  shader.glsl = std::move(written.glsl);
  shader.info = std::move(written.info);
  return shader;
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
