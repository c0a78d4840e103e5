// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/pair.h"

#include <vector>

#include "tools/draw/opengl/picture.h"
#include "tools/harness/framebuffer.h"

namespace clipc::draw {
namespace {

Inputs InputsOf(const GlProgram& program) {
  Inputs inputs = MeshInputs(program);
  for (const ActiveBlock& block : program.Blocks()) {
    const auto size = static_cast<std::size_t>(block.size);
    inputs.blocks.push_back({block.name, PairBlock(SeedOf(block.name), size)});
  }
  for (const Active& uniform : program.Uniforms()) {
    if (FindLayout(uniform.type)) throw DrawError("`" + uniform.name + "` is a plain uniform");
    inputs.textures.push_back(PairTexture(SeedOf(uniform.name)));
    inputs.textures.back().name = uniform.name;
  }
  return inputs;
}

std::vector<float> Draw(const Pair& pair) {
  GlProgram program(pair.vertex, pair.fragment, {});
  const harness::Framebuffer framebuffer(kPairSize, kPairSize, {GL_RGBA32F});
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  program.Bind(InputsOf(program));
  glDrawArrays(GL_TRIANGLES, 0, static_cast<int>(FullTarget().size()));
  std::vector<float> rgba = framebuffer.ReadFloats(GL_RGBA);
  harness::CheckErrors("drawing");
  return rgba;
}

}  // namespace

Inputs MeshInputs(const GlProgram& program) {
  Inputs inputs;
  inputs.vertices = static_cast<int>(FullTarget().size());
  for (const Active& attribute : program.Attributes()) {
    const auto location = static_cast<std::uint32_t>(attribute.location);
    inputs.attributes.push_back({attribute.name, PairAttribute(location, LayoutOf(attribute))});
  }
  return inputs;
}

PairDifference ComparePictures(const Pair& first, const Pair& second) {
  const std::vector<float> a = Draw(first), b = Draw(second);
  return CompareColors(a, b);
}

}  // namespace clipc::draw
