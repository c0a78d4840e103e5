// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "tools/draw/inputs.h"

// Pictures of whole programs, a vertex shader with a pixel shader, on any API: what is drawn, and
// how two pictures are compared.
namespace clipc::draw {

// A picture has so many pixels in each direction.
inline constexpr int kPairSize = 64;

// A number for a name, the same on every machine.
std::uint64_t SeedOf(std::string_view name);

// The values of an attribute for each vertex of FullTarget(): the position at location 0; random
// numbers elsewhere, small where they are integers. The shape is a scalar or a vector.
Words PairAttribute(std::uint32_t location, const Shape& shape);

// The bytes of a uniform block: the identity matrix in front, so that the mesh stays in view where
// that is one, and everything moved a little, so that every byte counts. A larger block of the same
// seed begins with the bytes of a smaller one.
Bytes PairBlock(std::uint64_t seed, std::size_t size);

// A texture of two dimensions, of random texels.
Inputs::Texture PairTexture(std::uint64_t seed);

struct PairDifference {
  int pixels = 0;
  int drawn = 0;      // in the second picture
  int colors = 0;     // that differ from each other in the second picture
  int different = 0;  // pixels whose colors are further apart than 1e-3 of their size, or of 0.05
};

// Compares two pictures of four floats for each pixel. A pixel is drawn where it is not 0.
PairDifference CompareColors(std::span<const float> first, std::span<const float> second);

}  // namespace clipc::draw
