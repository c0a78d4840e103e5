// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/pair.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tools/draw/opengl/image.h"
#include "tools/harness/framebuffer.h"

namespace clipc::draw {
namespace {

// The words of a block that hold integers, by the block's name.
using IntegerWords = std::map<std::string, std::set<std::size_t>>;
const std::set<std::size_t> kNoWords;

// The words of the program's blocks that it declares as ints, uints or bools. In an array of
// vectors of four uints are the bits of other members.
IntegerWords IntegersOf(const GlProgram& program) {
  IntegerWords words;
  for (const ActiveMember& member : program.Members()) {
    const std::optional<WordLayout> layout = FindLayout(member.type);
    if (!layout || layout->kind == WordKind::kFloat) continue;
    if (member.type == GL_UNSIGNED_INT_VEC4 && member.stride != 0) continue;
    for (int i = 0; i < member.count; ++i) {
      const auto first = static_cast<std::size_t>(member.offset + i * member.stride) / 4;
      for (int row = 0; row < layout->rows; ++row) words[member.block].insert(first + row);
    }
  }
  return words;
}

constexpr TextureForm kFloats{GL_NONE, WordKind::kFloat, false};
constexpr TextureForm kDepths{GL_NONE, WordKind::kFloat, true};
constexpr TextureForm kInts{GL_NONE, WordKind::kInt, false};
constexpr TextureForm kUints{GL_NONE, WordKind::kUint, false};

TextureForm Of(TextureForm form, GLenum target) {
  form.target = target;
  return form;
}

TextureForm FormOf(const Active& sampler) {
  switch (sampler.type) {
    case GL_SAMPLER_1D: return Of(kFloats, GL_TEXTURE_1D);
    case GL_SAMPLER_1D_ARRAY: return Of(kFloats, GL_TEXTURE_1D_ARRAY);
    case GL_SAMPLER_2D: return Of(kFloats, GL_TEXTURE_2D);
    case GL_SAMPLER_2D_ARRAY: return Of(kFloats, GL_TEXTURE_2D_ARRAY);
    case GL_SAMPLER_3D: return Of(kFloats, GL_TEXTURE_3D);
    case GL_SAMPLER_CUBE: return Of(kFloats, GL_TEXTURE_CUBE_MAP);
    case GL_SAMPLER_CUBE_MAP_ARRAY: return Of(kFloats, GL_TEXTURE_CUBE_MAP_ARRAY);
    case GL_SAMPLER_BUFFER: return Of(kFloats, GL_TEXTURE_BUFFER);
    case GL_SAMPLER_2D_MULTISAMPLE: return Of(kFloats, GL_TEXTURE_2D_MULTISAMPLE);
    case GL_SAMPLER_1D_SHADOW: return Of(kDepths, GL_TEXTURE_1D);
    case GL_SAMPLER_1D_ARRAY_SHADOW: return Of(kDepths, GL_TEXTURE_1D_ARRAY);
    case GL_SAMPLER_2D_SHADOW: return Of(kDepths, GL_TEXTURE_2D);
    case GL_SAMPLER_2D_ARRAY_SHADOW: return Of(kDepths, GL_TEXTURE_2D_ARRAY);
    case GL_SAMPLER_CUBE_SHADOW: return Of(kDepths, GL_TEXTURE_CUBE_MAP);
    case GL_SAMPLER_CUBE_MAP_ARRAY_SHADOW: return Of(kDepths, GL_TEXTURE_CUBE_MAP_ARRAY);
    case GL_INT_SAMPLER_1D: return Of(kInts, GL_TEXTURE_1D);
    case GL_INT_SAMPLER_1D_ARRAY: return Of(kInts, GL_TEXTURE_1D_ARRAY);
    case GL_INT_SAMPLER_2D: return Of(kInts, GL_TEXTURE_2D);
    case GL_INT_SAMPLER_2D_ARRAY: return Of(kInts, GL_TEXTURE_2D_ARRAY);
    case GL_INT_SAMPLER_3D: return Of(kInts, GL_TEXTURE_3D);
    case GL_INT_SAMPLER_BUFFER: return Of(kInts, GL_TEXTURE_BUFFER);
    case GL_INT_SAMPLER_2D_MULTISAMPLE: return Of(kInts, GL_TEXTURE_2D_MULTISAMPLE);
    case GL_UNSIGNED_INT_SAMPLER_1D: return Of(kUints, GL_TEXTURE_1D);
    case GL_UNSIGNED_INT_SAMPLER_1D_ARRAY: return Of(kUints, GL_TEXTURE_1D_ARRAY);
    case GL_UNSIGNED_INT_SAMPLER_2D: return Of(kUints, GL_TEXTURE_2D);
    case GL_UNSIGNED_INT_SAMPLER_2D_ARRAY: return Of(kUints, GL_TEXTURE_2D_ARRAY);
    case GL_UNSIGNED_INT_SAMPLER_3D: return Of(kUints, GL_TEXTURE_3D);
    case GL_UNSIGNED_INT_SAMPLER_BUFFER: return Of(kUints, GL_TEXTURE_BUFFER);
    case GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE: return Of(kUints, GL_TEXTURE_2D_MULTISAMPLE);
  }
  throw DrawError("`" + sampler.name + "` has a type that no pair is drawn with");
}

// Adds a texture for each element of the sampler.
void AddTextures(const Active& sampler, Inputs& inputs) {
  const bool is_array = sampler.name.ends_with("[0]");
  const std::string name = sampler.name.substr(0, sampler.name.size() - (is_array ? 3 : 0));
  for (int i = 0; i < sampler.count; ++i) {
    const std::string element = is_array ? name + "[" + std::to_string(i) + "]" : name;
    inputs.textures.push_back(PairTexture(SeedOf(element), FormOf(sampler)));
    inputs.textures.back().name = element;
  }
}

// The bytes of a block: its ints, uints and bools, as `program` declares them, are small numbers.
Bytes BytesOfBlock(const ActiveBlock& block, const std::set<std::size_t>& ints) {
  Words words = WordsOf(PairBlock(SeedOf(block.name), static_cast<std::size_t>(block.size)));
  for (const std::size_t at : ints) {
    if (at < words.size()) words[at] = (words[at] >> 4) % 6;
  }
  return BytesOf(words);
}

Inputs InputsOf(const GlProgram& program, const IntegerWords& ints) {
  Inputs inputs = MeshInputs(program);
  for (const ActiveBlock& block : program.Blocks()) {
    const auto found = ints.find(block.name);
    inputs.blocks.push_back(
        {block.name, BytesOfBlock(block, found == ints.end() ? kNoWords : found->second)});
  }
  for (const Active& uniform : program.Uniforms()) {
    if (FindLayout(uniform.type)) throw DrawError("`" + uniform.name + "` is a plain uniform");
    AddTextures(uniform, inputs);
  }
  return inputs;
}

std::vector<float> Draw(GlProgram& program, const IntegerWords& ints) {
  const harness::Framebuffer framebuffer(kPairSize, kPairSize, {GL_RGBA32F});
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  program.Bind(InputsOf(program, ints));
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

PairDifference CompareImages(const Pair& first, const Pair& second) {
  GlProgram one(first.vertex, first.fragment, {}), other(second.vertex, second.fragment, {});
  const IntegerWords ints = IntegersOf(one);
  const std::vector<float> a = Draw(one, ints), b = Draw(other, ints);
  return CompareColors(a, b);
}

}  // namespace clipc::draw
