// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "draw/build.h"

#include <regex>

#include "draw/gl.h"
#include "frontend/parse.h"
#include "frontend/source.h"

namespace clipc::draw {
namespace {

glsl::Target TargetOf(const std::string& name) {
  const std::optional<glsl::Target> target = glsl::Target::Parse(name);
  if (!target) throw DrawError("no target is called `" + name + "`");
  return *target;
}

ir::Program CheckFile(const BuildOptions& options) {
  const std::optional<ir::Profile> profile = ir::ParseProfile(options.profile);
  if (!profile) throw DrawError("no profile is called `" + options.profile + "`");
  FrontendContext context;
  SourceInput input;
  input.path = options.path;
  input.include_dirs = options.include_dirs;
  input.defines = options.defines;
  input.shader_model_major = profile->major;
  input.shader_model_minor = profile->minor;
  Source source(context, std::move(input));
  Diagnostics diagnostics;
  const auto stop_at_errors = [&] {
    if (diagnostics.has_errors()) throw DrawError("the shader has errors\n" + source.RenderText(diagnostics, false));
  };
  Tokens tokens = Lex(source, diagnostics);
  stop_at_errors();
  const ast::File file = Parse(std::move(tokens), diagnostics);
  stop_at_errors();
  const CheckOptions check{*profile, options.entry, options.packing, options.lowering == passes::Lowering::kLevel9};
  ir::Program program = Check(file, check, diagnostics);
  stop_at_errors();
  return program;
}

}  // namespace

Shader Build(const BuildOptions& options) {
  const glsl::Target target = TargetOf(options.target);
  Shader shader;
  shader.typed = CheckFile(options);
  shader.lowered = shader.typed;
  passes::PipelineOptions pipeline;
  pipeline.clip_planes.lowering = options.lowering;
  pipeline.clip_planes.write_clip_vertex = options.lowering == passes::Lowering::kLevel9 && target.HasClipVertex();
  pipeline.clip_space = options.clip_space;
  pipeline.verify = true;
  passes::RunPipeline(shader.lowered, pipeline);
  shader.glsl = glsl::WriteGlsl(shader.lowered, target, {}, &shader.info);
  return shader;
}

std::string WhyNot(const std::string& target, passes::Lowering lowering) {
  if (lowering == passes::Lowering::kClipDistance && !TargetOf(target).ClipDistance()) return "it has no clip distances";
  return "";
}

std::string ForOpenGl(const std::string& glsl) {
  std::string text = std::regex_replace(glsl, std::regex("set *= *[0-9]+ *, *"), "");
  text = std::regex_replace(text, std::regex("\\bgl_VertexIndex\\b"), "gl_VertexID");
  return std::regex_replace(text, std::regex("\\bgl_InstanceIndex\\b"), "gl_InstanceID");
}

}  // namespace clipc::draw
