// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/draw_call.h"

#include <algorithm>

#include "tools/draw/opengl/program.h"

namespace clipc::draw {

void ChooseInstances(const Shader& shader, RandomOptions& draw) {
  if (std::ranges::find(shader.typed.inputs, ir::Builtin::kInstanceId, &ir::IoVar::builtin) !=
      shader.typed.inputs.end())
    draw.instances = 3;
}

void ChooseDraw(const Shader& shader, RandomOptions& draw) {
  const StageInfo& stage = clipc::InfoOf(shader.typed.stage);
  if (stage.draws_pixels || stage.reads_vertices) return;
  ChooseInstances(shader, draw);
  const auto& inputs = shader.info.inputs;
  // Before GLSL 1.50 there are no draw calls with a base vertex.
  const Version version = VersionOf(shader.glsl);
  const bool from_zero = version.es || version.number < 150 ||
                         std::ranges::any_of(inputs, &GlslInfo::Variable::needs_base_vertex_zero);
  if (from_zero) return;
  draw.first_vertex = 5;
  draw.base_instance = 2;
}

}  // namespace clipc::draw
