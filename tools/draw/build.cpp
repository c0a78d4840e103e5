// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/build.h"

#include <regex>

#include "backend-glsl/check_target.h"
#include "frontend/lex/source.h"
#include "frontend/parse/parse.h"
#include "frontend/rules/position_input.h"

namespace clipc::draw {
namespace {

glsl::Target TargetOf(const std::string& name) {
  const std::optional<glsl::Target> target = glsl::Target::Parse(name);
  if (!target) throw DrawError("no target is called `" + name + "`");
  return *target;
}

// Reads, checks and lowers; stops at the first stage that reports an error.
class Chain {
 public:
  explicit Chain(const BuildOptions& options)
      : options_(options),
        target_(TargetOf(options.target)),
        profile_(ProfileOf(options.profile)),
        source_(context_, InputOf()) {}

  Tokens Preprocess() {
    Tokens tokens = Lex(source_, diagnostics_);
    StopAtErrors<DrawError>("the shader has errors");
    return tokens;
  }

  Shader Run() {
    const ast::File file = Parse(Preprocess(), diagnostics_);
    StopAtErrors<DrawError>("the shader has errors");
    const bool whole_registers = options_.lowering == Lowering::kLevel9;
    Shader shader;
    shader.typed =
        Check(file, {profile_, options_.entry, options_.packing, whole_registers}, diagnostics_);
    StopAtErrors<DrawError>("the shader has errors");
    if (options_.plane_space == PlaneSpace::kObject) {
      position_input_ = CheckPositionInput(shader.typed, options_.position_input, diagnostics_);
      StopAtErrors<DrawError>("the shader has errors");
    }
    shader.lowered = shader.typed;
    Lower(shader.lowered);
    glsl::Reached reached = glsl::CheckTarget(shader.lowered, target_, diagnostics_);
    StopAtErrors<NotForTarget>("not for this target");
    shader.glsl = glsl::WriteGlsl(shader.lowered, std::move(reached), target_, {}, &shader.info);
    return shader;
  }

 private:
  static ir::Profile ProfileOf(const std::string& name) {
    const std::optional<ir::Profile> profile = ir::ParseProfile(name);
    if (!profile) throw DrawError("no profile is called `" + name + "`");
    return *profile;
  }

  SourceInput InputOf() const {
    SourceInput input;
    input.path = options_.path;
    input.include_dirs = options_.include_dirs;
    input.defines = options_.defines;
    input.shader_model_major = profile_.major;
    input.shader_model_minor = profile_.minor;
    return input;
  }

  template <typename Error>
  void StopAtErrors(const std::string& what) const {
    if (diagnostics_.has_errors())
      throw Error(what + "\n" + source_.RenderText(diagnostics_, false));
  }

  void Lower(ir::Program& program) const {
    passes::PipelineOptions pipeline;
    pipeline.clip_planes.lowering = options_.lowering;
    pipeline.clip_planes.space = options_.plane_space;
    pipeline.clip_planes.position_input = position_input_;
    pipeline.clip_planes.write_clip_vertex =
        options_.lowering == Lowering::kLevel9 && target_.HasClipVertex();
    pipeline.clip_space = options_.clip_space;
    pipeline.verify = true;
    passes::RunPipeline(program, pipeline);
  }

  const BuildOptions& options_;
  glsl::Target target_;
  ir::Profile profile_;
  FrontendContext context_;
  Source source_;
  Diagnostics diagnostics_;
  ir::VarId position_input_;
};

}  // namespace

Shader Build(const BuildOptions& options) { return Chain(options).Run(); }
Tokens Preprocess(const BuildOptions& options) { return Chain(options).Preprocess(); }

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
