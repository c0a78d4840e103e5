// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/compare.h"

#include <algorithm>
#include <regex>

#include "tools/draw/dispatch.h"
#include "tools/draw/feed.h"
#include "tools/draw/vulkan/bind.h"
#include "tools/draw/vulkan/glslang.h"
#include "tools/draw/vulkan/several_vertices.h"

namespace clipc::draw::vulkan {
namespace {

// lavapipe of Mesa 22.3 loses an output when clip and cull distances share a vector: there cull
// distances are an output like any other.
std::string Capturable(const std::string& glsl) {
  static const std::regex kBoth(
      R"((\n +float gl_ClipDistance\[\d+\];)\n +float gl_CullDistance(\[\d+\];)\n\};)");
  const std::string text =
      std::regex_replace(glsl, kBoth, "$1\n};\nlayout(location = 24) out float cull_distance$2");
  return text == glsl ? glsl
                      : std::regex_replace(text, std::regex("gl_CullDistance"), "cull_distance");
}

// The outputs' values in one run of the shader.
std::vector<Captured> Run(const Runner& runner, const Spirv& spirv, const Trial& trial,
                          const std::vector<const Expected*>& outputs, const DrawCall& call) {
  const Shader& shader = trial.shader;
  const StageInfo& stage = clipc::InfoOf(shader.typed.stage);
  if (stage.runs_in_groups)
    return Chosen(CapturedMemory(shader, trial.inputs, runner.Dispatch(spirv, call)), outputs);
  if (stage.reads_vertices) return CaptureSeveral(runner, spirv, trial, outputs, call);
  if (!stage.draws_pixels) return runner.Capture(spirv, FindOutputs(spirv, outputs), call);
  const SurfaceSpace space{.is_vulkan = true, .flips_y = true};
  const Spirv vertex = SpirvOfGlsl(SurfaceVertexShader(shader, shader.glsl, space));
  return Chosen(runner.DrawSurface(vertex, spirv, TargetsOf(shader.lowered, shader.info), call,
                                   trial.draw.samples),
                outputs);
}

}  // namespace

std::vector<Output> FindOutputs(const Spirv& spirv, const std::vector<const Expected*>& expected) {
  const std::vector<Output> written = OutputsOf(spirv);
  std::vector<Output> found;
  for (const Expected* output : expected) {
    auto same = std::ranges::find(written, output->name, &Output::name);
    if (same == written.end() && output->name == "gl_CullDistance")
      same = std::ranges::find(written, "cull_distance", &Output::name);
    if (same == written.end()) throw DrawError("the shader does not write `" + output->name + "`");
    found.push_back(*same);
  }
  return found;
}

Comparison CompareWithVulkan(const Runner& runner, const Trial& trial) {
  const Shader& shader = trial.shader;
  const std::vector<const Expected*> outputs = Defined(trial.expected);
  if (outputs.empty()) return {};
  const Inputs inputs = MakeInputs(shader.lowered, shader.info, trial.inputs, trial.draw);
  const DrawCall call = MakeDrawCall(shader.lowered, shader.info, inputs);
  const auto compare = [&](const Spirv& spirv) {
    return CompareOutputs(outputs, Run(runner, spirv, trial, outputs, call), trial.tolerance);
  };
  const std::string glsl = Capturable(shader.glsl);
  const Comparison of_glsl = compare(SpirvOfGlsl(glsl, shader.typed.stage));
  if (of_glsl.wrong > 0 || glsl != shader.glsl) return of_glsl;
  return compare(shader.spirv);
}

}  // namespace clipc::draw::vulkan
