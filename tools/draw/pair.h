// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "tools/draw/inputs.h"

// Images of whole programs, a vertex shader with a pixel shader, on any API: what is drawn, and
// how two images are compared.
namespace clipc::draw {

// The width and the height of an image, in pixels.
inline constexpr int kPairSize = 64;

// A number for a name, the same on every machine.
std::uint64_t SeedOf(std::string_view name);

// The values of an attribute for each vertex of FullTarget(): the position at location 0; random
// numbers elsewhere, small where they are integers. The layout is a scalar or a vector.
Words PairAttribute(std::uint32_t location, const WordLayout& layout);

// The bytes of a uniform block: the identity matrix first, so that the mesh stays in view if the
// block begins with a matrix, and every value moved a little, so that every byte counts. A larger
// block of the same seed begins with the bytes of a smaller one.
Bytes PairBlock(std::uint64_t seed, std::size_t size);

// The kind of a texture, as GLSL's type of the sampler says it.
struct TextureForm {
  GLenum target = GL_TEXTURE_2D;
  WordKind kind = WordKind::kFloat;
  bool compares = false;
};
// A texture of random texels, a level for each size down to 1; a multisampled one has samples that
// differ. Integers are small, and negative
// where they have a sign.
Inputs::Texture PairTexture(std::uint64_t seed, const TextureForm& form = {});

struct PairDifference {
  int pixels = 0;
  int drawn = 0;      // pixels drawn in the second image
  int colors = 0;     // different colors in the second image
  int different = 0;  // pixels whose colors are further apart than 1e-3 of their size, or of 0.05
};

// Compares two images of four floats for each pixel. A pixel is drawn where it is not 0.
PairDifference CompareColors(std::span<const float> first, std::span<const float> second);

}  // namespace clipc::draw
