// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/patches.h"

#include <utility>

#include "tools/draw/opengl/geometry.h"
#include "tools/draw/pass_patch.h"

namespace clipc::draw {
namespace {

void Replace(std::string& text, std::string_view old, std::string_view with) {
  for (std::size_t at = text.find(old); at != text.npos; at = text.find(old, at + with.size()))
    text.replace(at, old.size(), with);
}

// The hull shader, which gives its factors as data.
std::string WithFactorsAsData(std::string text, const Shader& shader, PassOnFor api) {
  for (const FactorsAsData& data : kFactors) Replace(text, data.builtin, data.name);
  text.insert(text.find("void main()"), FactorsText(shader, "out", api) + "\n");
  text.insert(text.rfind('}'), "    gl_TessLevelOuter[0] = 1.0;\n    gl_TessLevelOuter[1] = " +
                                   std::to_string(SegmentsOf(shader.lowered)) + ".0;\n");
  return text;
}

}  // namespace

std::vector<Captured> MakePatches(const std::string& hull, const std::vector<std::string>& names,
                                  const Trial& trial, Inputs inputs) {
  const ir::Program& program = trial.shader.lowered;
  const Version version = VersionOf(hull);
  const PassOnFor api = version.es ? PassOnFor::kOpenGlEs : PassOnFor::kOpenGl;
  const TakenOut taken = TakeOut(trial.shader, names, api);
  PatchRun run;
  run.vertex = version.Head() + PassOnInto(inputs, version, trial.shader, trial.inputs).vertex;
  run.control = WithFactorsAsData(hull, trial.shader, api);
  run.evaluation = version.Head() + taken.text;
  run.patch_vertices = VerticesOfOne(program);
  run.most_points =
      inputs.vertices / run.patch_vertices * (static_cast<int>(SegmentsOf(program)) + 1);
  return InOrder(program, CapturePatches(run, taken.names, inputs));
}

}  // namespace clipc::draw
