// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>

#include "matrix.h"

/// Finds the clip planes that an object needs: most objects need none, and many are clipped away
/// whole. The plans are safe to the pixel: whatever order and fusing a shader uses for its dot
/// products, no vertex inside the box gets a distance whose sign contradicts the plan. A plane that
/// is not needed can therefore be left out, and a culled object need not be drawn, without changing
/// the image. There is no tolerance: a surface just outside of a plane may fill the screen.
///
/// Pure functions: any thread, no allocation.
namespace clipc::runtime {

/// The planes that an object needs: bit i for each plane i that may cut it; or kCulled alone if the
/// whole object is on the clipped side of a plane.
using BoxPlan = std::uint8_t;
inline constexpr BoxPlan kCulled = 0x80;

/// An axis-aligned box around all vertices of an object, in the space in which the shader dots the
/// vertices with the planes. A box whose bounds are not finite or not in order needs every plane.
struct Box {
  float low[3];
  float high[3];
};

/// Boxes as six arrays of `count` floats. They need no alignment.
struct BoxArrays {
  const float* low[3];  ///< x, y, z
  const float* high[3];
  std::size_t count;
};

/// The plan for shaders that compute dot(float4(v, 1), plane) with the vertex itself (plane space
/// `object`), or with a world- or view-space vertex if the box bounds the rounded vertices. Box and
/// planes are in one space. Planes after the sixth are ignored.
///
/// A plane is not needed if d >= E at the box's nearest corner, and culls if d < -E at the
/// farthest, in float; otherwise it is needed. E = 10 u S + 2^-120 + 2^-126 F with u = 2^-24, the
/// sum S = sum |n_i| max(|low_i|, |high_i|) + |D|, and F = sum |n_i| + max(|low_i|, |high_i|).
/// Proof: each d has four products and three sums, an error of at most 4u S / (1 - 4u); the
/// shader's dot product has an error of the same size, in any order, fused or not; S is computed at
/// most 5u too small; products and sums that underflow are below 2^-120 in total; coefficients and
/// coordinates below 2^-126, which a device may flush to 0, lose the last term.
BoxPlan PlanBox(const Box& box, const Float4* planes, std::size_t plane_count) noexcept;

/// Plans many boxes: each plan is exactly PlanBox of its box.
void PlanBoxes(const BoxArrays& boxes, const Float4* planes, std::size_t plane_count,
               BoxPlan* plans) noexcept;

/// The plan for shaders that dot a transformed position, as for plane space `clip` and
/// SetClipPlane: dot(position, plane) with position = v * matrices[0] * ... * matrices[matrix_count
/// - 1], each step in float. The box is in object space, the planes are in clip space. `matrices`
/// are those that the shader multiplies by, in order (one matrix if the application multiplies them
/// itself), with the float values that the shader receives.
///
/// The rule is that of PlanBox with E = 5 steps u S + 2^-120 and what flushing loses, where steps =
/// matrix_count + 1 and S = |v| |M_0| |M_1| ... |plane|, and with the corners in double. If depth
/// is not reversed, S is hundreds of times larger than in object space, and more planes are needed.
BoxPlan PlanTransformedBox(const Box& box, const Matrix* matrices, std::size_t matrix_count,
                           const Float4* planes, std::size_t plane_count) noexcept;

}  // namespace clipc::runtime
