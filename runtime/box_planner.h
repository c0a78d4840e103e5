// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/matrix.h"

// Which clip planes does an object need? Most need none, and many are clipped away whole. The
// answers here are safe to the pixel: whatever order and fusing a shader uses for its dot products,
// no vertex inside the box gets a distance whose sign contradicts the answer. So a plane that is
// not needed can be left out, and a culled object need not be drawn, without changing the picture.
// There is no tolerance to loosen: a surface just behind a plane fills the screen however close it
// is.
//
// Pure functions: any thread, no allocation.
namespace clipc::runtime {

// What an object needs: bit i for a plane i that may cut it, or kCulled alone: a plane has the
// whole object on its clipped side.
using BoxPlan = std::uint8_t;
inline constexpr BoxPlan kCulled = 0x80;

// An axis-aligned box around all vertices of an object, in the space of the vertices that the
// shader dots with the planes. Bounds that are not finite or not in order are a box that needs
// every plane.
struct Box {
  float low[3];
  float high[3];
};

// Boxes as six arrays of `count` floats. They need no alignment.
struct BoxArrays {
  const float* low[3];  // x, y, z
  const float* high[3];
  std::size_t count;
};

// For shaders that compute dot(float4(v, 1), plane) with the vertex itself: plane space `object`;
// or with a world- or view-space vertex, if the box bounds those rounded vertices. Box and planes
// in one space. `plane_count` is at most 6, further ones are ignored.
//
// A plane is not needed where d >= E at the box's nearest corner, and culls where d < -E at the
// farthest, in float; else it is needed. E = 10 u S + 2^-120 with u = 2^-24 and S = sum |n_i|
// max(|low_i|, |high_i|) + |D|. Proof: each d has four products and three sums, an error of at most
// 4u S / (1 - 4u); the shader's dot product has another one of that size, in any order, fused or
// not; S itself is computed 5u too small at most; what underflows is below 2^-120 altogether.
BoxPlan PlanBox(const Box& box, const Float4* planes, std::size_t plane_count) noexcept;

// The same for many boxes: exactly PlanBox of each.
void PlanBoxes(const BoxArrays& boxes, const Float4* planes, std::size_t plane_count,
               BoxPlan* plans) noexcept;

// For shaders that dot a transformed position: position = v * matrices[0] * ... *
// matrices[matrix_count - 1], each step in float, dot(position, plane). Plane space `clip`,
// SetClipPlane and [clipplanes]: the box is in object space, the planes in clip space. `matrices`
// are those that the shader multiplies by, one after the other (one matrix if the application
// multiplies them itself), with the float values that the shader gets.
//
// As above with E = 5 steps u S + 2^-120, where steps is matrix_count + 1 and S = |v| |M_0| |M_1|
// ... |plane|, and with the corners in double. With depth that is not reversed S is hundreds of
// times larger than in object space, and more planes are needed.
BoxPlan PlanTransformedBox(const Box& box, const Matrix* matrices, std::size_t matrix_count,
                           const Float4* planes, std::size_t plane_count) noexcept;

}  // namespace clipc::runtime
