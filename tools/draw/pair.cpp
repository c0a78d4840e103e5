// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/pair.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>

#include "tools/draw/opengl/image.h"
#include "tools/harness/random.h"

namespace clipc::draw {
namespace {

std::uint32_t Bits(double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); }

bool AreAlike(float a, float b) {
  return a == b || (std::isnan(a) && std::isnan(b)) ||
         std::fabs(a - b) <= 1e-3 * std::max({0.05f, std::fabs(a), std::fabs(b)});
}

}  // namespace

std::uint64_t SeedOf(std::string_view name) {
  std::uint64_t seed = 14695981039346656037u;  // FNV-1a
  for (const char c : name) seed = (seed ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return seed;
}

Words PairAttribute(std::uint32_t location, const WordLayout& layout) {
  harness::Random random(SeedOf("attribute") + location);
  Words words;
  for (const auto& [x, y, z, w] : FullTarget()) {
    const double position[] = {x / w, y / w, z / w, 1};
    for (int i = 0; i < layout.rows; ++i) {
      const double value = random.Unit();
      words.push_back(layout.kind != WordKind::kFloat ? static_cast<std::uint32_t>(4 * value)
                      : location == 0                 ? Bits(position[i])
                                                      : Bits(value));
    }
  }
  return words;
}

Bytes PairBlock(std::uint64_t seed, std::size_t size) {
  harness::Random random(seed);
  Words words;
  for (std::size_t word = 0; 4 * word < size; ++word) {
    const double base = word < 16 && word % 5 == 0 ? 1 : 0;
    words.push_back(Bits(base + random.Between(0.05, 0.25)));
  }
  return BytesOf(words);
}

Inputs::Texture PairTexture(std::uint64_t seed, const TextureForm& form) {
  harness::Random random(seed);
  Inputs::Texture texture;
  texture.target = form.target, texture.kind = form.kind, texture.compares = form.compares;
  const auto word = [&] {
    if (form.kind == WordKind::kFloat) return Bits(random.Unit());
    const auto number = static_cast<std::uint32_t>(200 * random.Unit());
    return form.kind == WordKind::kInt ? number - 100 : number;
  };
  const auto add_level = [&](std::array<std::uint32_t, 3> size, std::uint32_t faces) {
    Inputs::Texture::Level& level = texture.levels.emplace_back();
    level.size = size;
    const std::uint32_t texels = size[0] * size[1] * size[2] * faces;
    for (std::uint32_t i = 0; i < (form.compares ? 1 : 4) * texels; ++i)
      level.words.push_back(word());
  };
  const std::uint32_t faces = form.target == GL_TEXTURE_CUBE_MAP ? 6 : 1;
  for (std::uint32_t width = 8; width != 0; width /= 2) {
    switch (form.target) {
      case GL_TEXTURE_1D: add_level({width, 1, 1}, faces); break;
      case GL_TEXTURE_1D_ARRAY: add_level({width, 3, 1}, faces); break;
      case GL_TEXTURE_2D_ARRAY: add_level({width, width, 3}, faces); break;
      case GL_TEXTURE_CUBE_MAP_ARRAY: add_level({width, width, 12}, faces); break;
      case GL_TEXTURE_3D: add_level({width, width, width}, faces); break;
      case GL_TEXTURE_BUFFER: add_level({512, 1, 1}, faces); return texture;
      case GL_TEXTURE_2D_MULTISAMPLE: add_level({8, 8, kSamples}, faces); return texture;
      default: add_level({width, width, 1}, faces); break;
    }
  }
  return texture;
}

PairDifference CompareColors(std::span<const float> first, std::span<const float> second) {
  PairDifference found;
  std::set<std::array<float, 4>> colors;
  for (std::size_t i = 0; i < first.size(); i += 4) {
    const std::array<float, 4> color = {second[i], second[i + 1], second[i + 2], second[i + 3]};
    const bool is_drawn = color != std::array<float, 4>{};
    ++found.pixels;
    found.drawn += is_drawn;
    if (is_drawn) colors.insert(color);
    found.different += !std::ranges::equal(first.subspan(i, 4), color, AreAlike);
  }
  found.colors = static_cast<int>(colors.size());
  return found;
}

}  // namespace clipc::draw
