// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>

#include "runtime/matrix.h"
#include "runtime/plane_space.h"

/// The rounding errors of a vertex shader's float arithmetic, followed from the vertex to the cut.
/// Not part of the public interface.
namespace clipc::runtime {

/// The way of a vertex to its distance from the plane: v * matrices[0] * matrices[1] ..., from left
/// to right in float, dotted with the constant.
struct DistanceArithmetic {
  Matrix matrices[3];
  int count = 0;
  /// The matrices are multiplied with each other in float, and the vertex with their product.
  bool float_product = false;
  bool is_xyw1 = false;  ///< (x, y, w, 1) is dotted instead of (x, y, z, w)
  Plane constant;
};

/// The 99th percentile of the distance in pixels between the cut and where it belongs, over random
/// directions of the edges: those at an angle of `sine` to the plane, or all of 3 degrees and more
/// for kAnySurface. To first order: each operation rounds by a random number of the size that
/// rounding has there. `view_plane` has a unit normal; at most 256 places of the cut count.
/// Infinity where no place lies before the eye.
double EdgeErrorOf(const DistanceArithmetic& arithmetic, const Plane& view_plane,
                   const Matrix& world_view, const Matrix& projection, const SeenCut& cut,
                   double picture_height, double sine) noexcept;

}  // namespace clipc::runtime
