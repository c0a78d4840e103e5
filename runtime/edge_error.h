// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>

#include "matrix.h"
#include "plane_space.h"

/// The rounding errors of a vertex shader's float arithmetic, followed from the vertex to the cut.
/// Not part of the public interface.
namespace clipc::runtime {

/// How the application multiplies the matrices with each other in float; kNone: not at all, the
/// shader multiplies the vertex by one after the other.
enum class FloatProduct {
  kNone,
  kFromLeft,   ///< (matrices[0] matrices[1]) matrices[2]
  kFromRight,  ///< matrices[0] (matrices[1] matrices[2])
};

/// The way of a vertex to its distance from the plane: v * matrices[0] * matrices[1] ..., from left
/// to right in float, dotted with the constant.
struct DistanceArithmetic {
  Matrix matrices[3];
  int count = 0;
  FloatProduct product = FloatProduct::kNone;  ///< the vertex is multiplied with it
  bool is_xyw1 = false;                        ///< (x, y, w, 1) is dotted instead of (x, y, z, w)
  Plane constant;
};

/// The 99th percentile of the distance in pixels between the cut and where it belongs, over random
/// directions of the edges: those at an angle of `sine` to the plane, or all of 3 degrees and more
/// for kAnySurface. To first order: each operation rounds by a random number of the size that
/// rounding has there. `view_plane` has a unit normal; at most 256 places of the cut count.
/// Infinity where no place lies before the eye.
double EdgeErrorOf(const DistanceArithmetic& arithmetic, const Plane& view_plane,
                   const Matrix& world_view, const Matrix& projection, const SeenCut& cut,
                   double image_height, double sine) noexcept;

}  // namespace clipc::runtime
