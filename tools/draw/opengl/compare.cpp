// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/compare.h"

#include "tools/draw/dispatch.h"
#include "tools/draw/feed.h"
#include "tools/draw/opengl/dispatch.h"
#include "tools/draw/opengl/domain.h"
#include "tools/draw/opengl/geometry.h"
#include "tools/draw/opengl/patches.h"
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

// The outputs that can be read back: of OpenGL ES no images.
std::vector<const Expected*> Readable(std::vector<const Expected*> outputs, const Trial& trial,
                                      const Version& version) {
  if (!version.es || !clipc::InfoOf(trial.shader.typed.stage).runs_in_groups) return outputs;
  for (const MemoryPart& part : WrittenParts(trial.shader, trial.inputs)) {
    if (part.is_image)
      std::erase_if(outputs, [&](const Expected* output) { return output->name == part.name; });
  }
  return outputs;
}

}  // namespace

Comparison CompareWithOpenGl(harness::OpenGl& opengl, const Trial& trial) {
  const std::string text = Capturable(ForOpenGl(trial.shader.glsl));
  opengl.Use(VersionOf(text).api);
  const std::vector<const Expected*> outputs =
      Readable(Defined(trial.expected), trial, VersionOf(text));
  std::vector<std::string> names;
  for (const Expected* output : outputs) names.push_back(Capturable(output->name));
  if (outputs.empty()) return {};
  const Inputs inputs =
      MakeInputs(trial.shader.lowered, trial.shader.info, trial.inputs, trial.draw);
  const StageInfo& stage = clipc::InfoOf(trial.shader.typed.stage);
  const auto compare = [&](const std::string& of) {
    return CompareOutputs(
        outputs,
        stage.draws_pixels ? Drawn(of, outputs, trial, inputs)
        : stage.runs_in_groups
            ? Chosen(CapturedMemory(trial.shader, trial.inputs, Dispatch(of, inputs)), outputs)
        : stage.emits_vertices ? Emit(of, names, trial, inputs)
        : stage.reads_patches  ? Evaluate(of, names, trial, inputs)
        : stage.makes_patches  ? MakePatches(of, NamesOf(outputs), trial, inputs)
                               : Capture(of, names, inputs),
        trial.tolerance);
  };
  const Comparison of_glsl = compare(text);
  if (of_glsl.wrong > 0) return of_glsl;
  const std::string of_spirv = GlslOfSpirv(trial.shader);
  return of_spirv.empty() ? of_glsl : compare(Capturable(of_spirv));
}

}  // namespace clipc::draw
