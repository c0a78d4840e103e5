// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/several_vertices.h"

#include <algorithm>
#include <utility>

#include "tools/draw/pass_patch.h"
#include "tools/draw/vulkan/compare.h"
#include "tools/draw/vulkan/glslang.h"

namespace clipc::draw::vulkan {
namespace {

Spirv SpirvOf(const std::string& text, Stage stage) {
  return SpirvOfGlsl("#version 450\n" + text, stage);
}

// Lets the call have the vertices that are passed on.
void Give(PassedOn& passed, DrawCall& call) {
  call.vertices = passed.vertices;
  call.instances = 1;
  call.first_vertex = call.base_instance = 0;
  for (PassedOn::Attribute& attribute : passed.attributes)
    call.attributes.push_back({static_cast<std::uint32_t>(call.attributes.size()), attribute.kind,
                               std::move(attribute.words)});
}

// Returns the outputs of a domain shader in its text that have these names.
std::vector<Output> OutputsCalled(const Spirv& domain, const std::vector<std::string>& names) {
  std::vector<Output> outputs;
  const std::vector<Output> written = OutputsOf(domain);
  for (const std::string& name : names)
    outputs.push_back(*std::ranges::find(written, name, &Output::name));
  return outputs;
}

}  // namespace

std::vector<Captured> CaptureSeveral(const Runner& runner, const Spirv& spirv, const Trial& trial,
                                     const std::vector<const Expected*>& outputs, DrawCall call) {
  const ir::Program& program = trial.shader.lowered;
  const StageInfo& stage = clipc::InfoOf(program.stage);
  PassedOn passed = PassOn(trial.shader, trial.inputs, PassOnFor::kVulkan);
  Give(passed, call);
  Runner::Stages stages;
  stages.vertex = SpirvOf(passed.vertex, Stage::kVertex);
  const int size = VerticesOfOne(program), primitives = call.vertices / size;
  if (stage.emits_vertices) {
    stages.after = {WithPoints(spirv)};
    stages.primitive = static_cast<int>(program.emission.input);
    stages.most = MostEmitted(program.emission, call.vertices);
    return runner.CaptureLast(stages, FindOutputs(spirv, outputs), call);
  }
  stages.patch_points = static_cast<std::uint32_t>(size);
  if (stage.reads_patches) {
    stages.after = {SpirvOf(passed.hull, Stage::kHull), WithPoints(spirv)};
    stages.most = primitives * kMostPoints;
    return runner.CaptureLast(stages, FindOutputs(spirv, outputs), call);
  }
  const std::uint32_t segments = SegmentsOf(program);
  const TakenOut taken = TakeOut(trial.shader, NamesOf(outputs), PassOnFor::kVulkan);
  const Spirv domain = SpirvOf(taken.text, Stage::kDomain);
  stages.after = {WithFactorsAsData(spirv, segments), domain};
  stages.most = primitives * (static_cast<int>(segments) + 1);
  return InOrder(program, runner.CaptureLast(stages, OutputsCalled(domain, taken.names), call));
}

}  // namespace clipc::draw::vulkan
