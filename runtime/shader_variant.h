// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/box_planner.h"
#include "runtime/matrix.h"

// From a plan to a draw: `clipc --variants` writes the shader for every plane count 0..n, planes
// compacted to the front, and this picks the one with just the planes that an object needs. Pure
// functions: any thread, no allocation.
namespace clipc::runtime {

// Which shader to draw with, and which of the object's planes goes to each of its constants.
struct ShaderVariant {
  std::uint8_t plane_count =
      0;  // the variant with this many planes; its enable mask is (1 << plane_count) - 1
  std::uint8_t planes[6] =
      {};  // the variant's plane s is the object's plane planes[s], in ascending order
};

// For a plan without kCulled: bits 0 to 5.
constexpr ShaderVariant VariantOf(BoxPlan plan) noexcept {
  ShaderVariant variant;
  for (std::uint8_t i = 0; i < 6; ++i) {
    if ((plan >> i & 1) != 0) variant.planes[variant.plane_count++] = i;
  }
  return variant;
}

// Copies the planes that `variant` uses to the front of `to`, which has room for plane_count of
// them.
void CompactPlanes(const ShaderVariant& variant, const Float4* from, Float4* to) noexcept;

// The order to draw in, so that each variant is bound once: `order` gets the indices of all objects
// that are not culled, by number of planes, and in the given order where that is equal. Objects
// with k planes are order[first[k]] up to, without, order[first[k + 1]]; first[7] is how many are
// drawn. `order` has room for `count` indices.
void OrderByPlaneCount(const BoxPlan* plans, std::size_t count, std::uint32_t* order,
                       std::size_t (&first)[8]) noexcept;

}  // namespace clipc::runtime
