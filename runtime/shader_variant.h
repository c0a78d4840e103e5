// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>

#include "box_planner.h"
#include "matrix.h"

/// From a plan to a draw: `clipc --variants` writes a shader for every plane count from 0 to n,
/// with its planes numbered from 0; these functions choose the one with exactly the planes that an
/// object needs. Pure functions: any thread, no allocation.
namespace clipc::runtime {

/// The shader variant to draw an object with, and the object's plane for each of its constants.
struct ShaderVariant {
  /// The variant's planes; its enable mask is (1 << plane_count) - 1.
  std::uint8_t plane_count = 0;
  /// Plane s of the variant is plane planes[s] of the object, ascending.
  std::uint8_t planes[6] = {};
};

/// The variant for a plan without kCulled.
constexpr ShaderVariant VariantOf(BoxPlan plan) noexcept {
  ShaderVariant variant;
  for (std::uint8_t i = 0; i < 6; ++i) {
    if ((plan >> i & 1) != 0) variant.planes[variant.plane_count++] = i;
  }
  return variant;
}

/// Copies the planes that `variant` uses, from[planes[s]] to to[s]. `to` has room for
/// variant.plane_count planes.
void CompactPlanes(const ShaderVariant& variant, const Float4* from, Float4* to) noexcept;

/// The drawing order in which each variant is bound once: `order` receives the indices of all
/// objects that are not culled, sorted by number of planes and then by index. The objects with k
/// planes are order[first[k]] to order[first[k + 1] - 1]; first[7] is the number of objects drawn.
/// `order` has room for `count` indices.
void OrderByPlaneCount(const BoxPlan* plans, std::size_t count, std::uint32_t* order,
                       std::size_t (&first)[8]) noexcept;

}  // namespace clipc::runtime
