// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "matrix.h"
#include "status.h"

namespace clipc::runtime {

/// The matrix that mirrors points of the plane's space in the plane, for row vectors:
/// v => v - 2 Dot(plane, v) N / |N|^2 with N = (x, y, z). The matrix is its own inverse. It turns
/// clockwise triangles into anticlockwise ones, so a draw with it swaps the cull mode. Any positive
/// or negative multiple of `plane` gives the same matrix.
///
/// A planar reflection, such as water, draws the scene with view_mirrored = Multiply(mirror, view),
/// clipped by the water's plane: ClipPlaneFromWorld(water, view_mirrored, projection) keeps what is
/// above the water.
///
/// Errors: kSingular if the plane has no normal; kNotFinite; kNotRepresentable if the mirror is so
/// far from the origin that the translation overflows.
Result<Matrix> MirrorMatrix(const Plane& plane) noexcept;

}  // namespace clipc::runtime
