// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "matrix.h"
#include "status.h"

namespace clipc::runtime {

/// The range of z/w in the target's clip space, and the end of it that is near.
struct DepthRange {
  /// True: OpenGL's -w <= z <= w. False: Direct3D's and Vulkan's 0 <= z <= w.
  bool negative_one_to_one = false;
  bool reversed = false;  ///< reverse-Z: the near plane is at z = w
};

/// A projection matrix for row vectors, as every graphics API shapes it:
///
///   px  0   0  0        px, py   scales; negative where an axis is mirrored (y down)
///   0   py  0  0        ox, oy   shift of an off-centre or jittered perspective
///   ox  oy  a  e        tx, ty   shift of an off-centre orthographic frustum
///   tx  ty  b  g        a, b     depth
///
///   perspective         g = 0; e = 1 if the view looks along +z, e = -1 if along -z
///   orthographic        e = 0; g = 1
///
/// A shape holds when the other elements are exactly 0, px and py are not, and one of e and g is
/// exactly 0. It has an inverse when b (perspective) or a (orthographic) is not 0 either.
struct ProjectionShape {
  bool holds = false;
  double px = 0, py = 0, ox = 0, oy = 0, a = 0, e = 0, tx = 0, ty = 0, b = 0, g = 0;

  bool is_perspective() const noexcept { return holds && g == 0; }
  bool is_orthographic() const noexcept { return holds && e == 0; }
};

ProjectionShape ShapeOf(const Matrix& projection) noexcept;

/// True for an affine matrix whose translation is in its last column instead of its last row, where
/// row vectors have it: the last row is (0, 0, 0, 1), and the last column is not.
bool LooksTransposed(const Matrix& affine) noexcept;

/// Reports a matrix that cannot be a projection: kNotFinite for NaN and infinity; kLooksTransposed
/// where LooksTransposed, and for a perspective whose last row is (0, 0, 1, 0) or (0, 0, -1, 0),
/// which is the last column of one for row vectors, and whose own last column is not that.
Status CheckProjection(const Matrix& projection) noexcept;

/// The clip-space w of the near plane of the perspective `shape`; if e is 1 or -1, the near
/// distance.
double NearW(const ProjectionShape& shape, DepthRange range) noexcept;

}  // namespace clipc::runtime
