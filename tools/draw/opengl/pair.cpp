// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/pair.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "tools/draw/opengl/picture.h"
#include "tools/draw/opengl/program.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/random.h"

namespace clipc::draw {
namespace {

constexpr int kSize = 64;

std::uint32_t Bits(double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); }

// Equal for equal names, on every machine.
std::uint64_t SeedOf(std::string_view name) {
  std::uint64_t seed = 14695981039346656037u;  // FNV-1a
  for (const char c : name) seed = (seed ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return seed;
}

// The attribute at location 0 is the position, of a mesh over the whole target; the others are
// random, small where they are integers.
Words AttributeWords(const Active& active) {
  const Shape shape = ShapeOf(active);
  harness::Random random(SeedOf("attribute") + static_cast<std::uint64_t>(active.location));
  Words words;
  for (const auto& [x, y, z, w] : FullTarget()) {
    const double position[] = {x / w, y / w, z / w, 1};
    for (int i = 0; i < shape.rows; ++i) {
      const double value = random.Unit();
      words.push_back(shape.kind != WordKind::kFloat ? static_cast<std::uint32_t>(4 * value)
                      : active.location == 0         ? Bits(position[i])
                                                     : Bits(value));
    }
  }
  return words;
}

// The identity matrix in front, so that the mesh stays in view where that is one, and everything is
// moved a little, so that every byte counts.
Bytes BlockBytes(const ActiveBlock& block) {
  harness::Random random(SeedOf(block.name));
  Bytes bytes;
  for (int word = 0; 4 * word < block.size; ++word) {
    const double base = word < 16 && word % 5 == 0 ? 1 : 0;
    const std::uint32_t bits = Bits(base + random.Between(0.05, 0.25));
    for (int shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<std::uint8_t>(bits >> shift));
  }
  return bytes;
}

Inputs::Texture TextureFor(const std::string& name) {
  harness::Random random(SeedOf(name));
  Inputs::Texture texture;
  texture.name = name;
  texture.target = GL_TEXTURE_2D;
  Inputs::Texture::Level& level = texture.levels.emplace_back();
  level.size = {8, 8, 1};
  for (int i = 0; i < 4 * 8 * 8; ++i) level.words.push_back(Bits(random.Unit()));
  return texture;
}

Inputs InputsOf(const GlProgram& program) {
  Inputs inputs;
  inputs.vertices = static_cast<int>(FullTarget().size());
  for (const Active& attribute : program.Attributes())
    inputs.attributes.push_back({attribute.name, AttributeWords(attribute)});
  for (const ActiveBlock& block : program.Blocks())
    inputs.blocks.push_back({block.name, BlockBytes(block)});
  for (const Active& uniform : program.Uniforms()) {
    if (FindShape(uniform.type)) throw DrawError("`" + uniform.name + "` is a plain uniform");
    inputs.textures.push_back(TextureFor(uniform.name));
  }
  return inputs;
}

std::vector<float> Draw(const Pair& pair) {
  GlProgram program(pair.vertex, pair.fragment, {});
  const harness::Framebuffer framebuffer(kSize, kSize, {GL_RGBA32F});
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  program.Bind(InputsOf(program));
  glDrawArrays(GL_TRIANGLES, 0, static_cast<int>(FullTarget().size()));
  std::vector<float> rgba = framebuffer.ReadFloats(GL_RGBA);
  harness::CheckErrors("drawing");
  return rgba;
}

bool AreAlike(float a, float b) {
  return a == b || (std::isnan(a) && std::isnan(b)) ||
         std::fabs(a - b) <= 1e-3 * std::max({1.0f, std::fabs(a), std::fabs(b)});
}

}  // namespace

PairDifference ComparePictures(const Pair& first, const Pair& second) {
  const std::vector<float> a = Draw(first), b = Draw(second);
  PairDifference found;
  std::set<std::array<float, 4>> colors;
  for (std::size_t i = 0; i < a.size(); i += 4) {
    const std::array<float, 4> color = {b[i], b[i + 1], b[i + 2], b[i + 3]};
    const bool is_drawn = color != std::array<float, 4>{};
    ++found.pixels;
    found.drawn += is_drawn;
    if (is_drawn) colors.insert(color);
    found.different += !std::ranges::equal(std::span(a).subspan(i, 4), color, AreAlike);
  }
  found.colors = static_cast<int>(colors.size());
  return found;
}

}  // namespace clipc::draw
