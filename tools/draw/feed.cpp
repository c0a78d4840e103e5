// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/feed.h"

#include <bit>

#include "ir/scalar.h"
#include "tools/draw/memory.h"

namespace clipc::draw {
namespace {

using namespace ir;

void GiveAttributes(const Program& program, const GlslInfo& info, const RandomInputs& random,
                    Inputs& inputs) {
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    if (program.inputs[i].builtin != Builtin::kNone || clipc::InfoOf(program.stage).reads_vertices)
      continue;
    const GlslInfo::Variable& written = info.inputs.at(i);
    const Type& type = program.types[program.vars[program.inputs[i].var].type];
    const Scalar kind = BaseOf(type.scalar);
    Inputs::Attribute attribute{written.name, {}};
    for (int vertex = 0; vertex < inputs.vertices; ++vertex) {
      for (std::uint32_t k = 0; k < type.Components(); ++k) {
        const std::uint32_t word = random.vertices[vertex][i][k];
        attribute.words.push_back(written.integer_as_float ? AsFloat(word, kind) : word);
      }
    }
    inputs.attributes.push_back(std::move(attribute));
  }
}

}  // namespace

std::uint32_t AsFloat(std::uint32_t word, Scalar kind) {
  const double number =
      kind == Scalar::kInt ? static_cast<std::int32_t>(word) : static_cast<double>(word);
  return std::bit_cast<std::uint32_t>(static_cast<float>(number));
}

Inputs MakeInputs(const Program& program, const GlslInfo& info, const RandomInputs& random,
                  const RandomOptions& draw) {
  Inputs inputs;
  inputs.instances = draw.instances;
  inputs.vertices = draw.vertices;
  inputs.first_vertex = draw.first_vertex;
  inputs.base_instance = draw.base_instance;
  if (clipc::InfoOf(program.stage).draws_pixels) {
    GiveSurface(program, random.surface, inputs);
    if (!info.framebuffer_height.empty()) {
      const auto height = static_cast<float>(kSurfaceHeight);
      inputs.uniforms.push_back({info.framebuffer_height, {std::bit_cast<std::uint32_t>(height)}});
    }
  } else {
    GiveAttributes(program, info, random, inputs);
  }
  GiveConstants(program, info, random.cbuffers, inputs);
  GiveTextures(program, info, random.textures, inputs);
  GiveBuffers(program, info, random.buffers, inputs);
  return inputs;
}

}  // namespace clipc::draw
