// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/compare.h"

#include "tools/draw/feed.h"
#include "tools/draw/opengl/program.h"
#include "tools/draw/opengl/surface.h"
#include "tools/draw/vulkan/opengl_text.h"

namespace clipc::draw {
namespace {

// Renames cull distances, which Mesa 22.3 does not capture, into an ordinary output.
std::string Capturable(std::string text) {
  constexpr std::string_view kCull = "gl_CullDistance";
  for (std::size_t at = text.find(kCull); at != std::string::npos; at = text.find(kCull, at)) {
    text.replace(at, kCull.size(), "cull_distance");
  }
  return text;
}

// The outputs of a pixel shader.
std::vector<Captured> Drawn(const std::string& text, const std::vector<const Expected*>& outputs,
                            const Trial& trial, const Inputs& inputs) {
  const SurfaceSpace space{.is_vulkan = false, .flips_y = trial.shader.flips_y};
  return Chosen(DrawSurface(SurfaceVertexShader(trial.shader, text, space), text,
                            TargetsOf(trial.shader.lowered, trial.shader.info), inputs, space,
                            trial.draw.samples),
                outputs);
}

}  // namespace

Comparison CompareWithOpenGl(harness::OpenGl& opengl, const Trial& trial) {
  const std::string text = Capturable(ForOpenGl(trial.shader.glsl));
  opengl.Use(VersionOf(text).api);
  const std::vector<const Expected*> outputs = Defined(trial.expected);
  std::vector<std::string> names;
  for (const Expected* output : outputs) names.push_back(Capturable(output->name));
  if (outputs.empty()) return {};
  const Inputs inputs =
      MakeInputs(trial.shader.lowered, trial.shader.info, trial.inputs, trial.draw);
  const bool draws_pixels = clipc::InfoOf(trial.shader.typed.stage).draws_pixels;
  const auto compare = [&](const std::string& of) {
    return CompareOutputs(
        outputs, draws_pixels ? Drawn(of, outputs, trial, inputs) : Capture(of, names, inputs),
        trial.tolerance);
  };
  const Comparison of_glsl = compare(text);
  if (of_glsl.wrong > 0) return of_glsl;
  const std::string of_spirv = GlslOfSpirv(trial.shader);
  return of_spirv.empty() ? of_glsl : compare(Capturable(of_spirv));
}

}  // namespace clipc::draw
