// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "runtime/matrix.h"

namespace clipc::runtime {

// Where z/w of the target's clip space lies, and which end is near.
struct DepthRange {
  bool negative_one_to_one =
      false;              // OpenGL's -w <= z <= w; otherwise Direct3D's and Vulkan's 0 <= z <= w
  bool reversed = false;  // reverse-Z: the near plane is at z = w
};

// What a projection matrix for row vectors looks like in every graphics API:
//
//   px  0   0  0        px, py   scales, possibly negative (y down)
//   0   py  0  0        ox, oy   off-centre or jittered frustum
//   ox  oy  a  e        a, b     depth; e is 1 (view looks along +z) or -1 (along -z) for a perspective, 0 for
//   orthographic tx  ty  b  g        tx, ty   shift of an orthographic frustum; g is 0 for a perspective, 1 for
//   orthographic
//
// A shape holds when the other elements are exactly 0, px and py are not, and one of e and g is
// exactly 0. It has an inverse when b (perspective) or a (orthographic) is not 0 either.
struct ProjectionShape {
  bool holds = false;
  double px = 0, py = 0, ox = 0, oy = 0, a = 0, e = 0, tx = 0, ty = 0, b = 0, g = 0;

  bool is_perspective() const noexcept { return holds && g == 0; }
  bool is_orthographic() const noexcept { return holds && e == 0; }
};

ProjectionShape ShapeOf(const Matrix& projection) noexcept;

// The clip-space w at which the perspective `shape` has its near plane: for e = 1 or -1, the near
// distance n.
double NearW(const ProjectionShape& shape, DepthRange range) noexcept;

}  // namespace clipc::runtime
