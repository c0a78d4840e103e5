// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>

#include "matrix.h"
#include "plane_space.h"
#include "vertex_rounding.h"

/// The rounding errors of a vertex shader's float arithmetic, followed from the vertex to the cut.
/// Not part of the public interface.
namespace clipc::runtime {

using rounding::FloatProduct;
using rounding::VertexArithmetic;

/// The way of a vertex to its distance from the plane: through the matrices, and dotted with the
/// constant.
struct DistanceArithmetic : VertexArithmetic {
  bool is_xyw1 = false;  ///< (x, y, w, 1) is dotted instead of (x, y, z, w)
  Plane constant;
};

/// What of a draw its errors depend on: `view_plane` has a unit normal, `position` is the way of a
/// vertex to its position in the image.
struct SeenDraw {
  Plane view_plane;
  Matrix world_view, projection;
  VertexArithmetic position;
  bool with_vertices = true;  ///< else the vertices count as where they belong
};

/// The way of a vertex to its position by the matrices of a draw.
VertexArithmetic PositionArithmetic(const DrawMatrices& draw) noexcept;

/// The displacements of a draw's edges, to first order: each operation rounds by a random number of
/// the size that rounding has there. They are 99th percentiles in pixels over random directions of
/// the edges: those at an angle of `sine` to the plane, or all of 3 degrees and more for
/// kAnySurface. At most 256 places of the cut count. All are infinity where no place lies before
/// the eye.
EdgeDisplacement EdgeErrorOf(const DistanceArithmetic& arithmetic, const SeenDraw& draw,
                             const SeenCut& cut, double image_height, double sine) noexcept;

/// The same where the application clips in double: the cut is an edge between vertices, which are
/// rounded to float in the object's own space.
EdgeDisplacement ClippedVertexErrorOf(const SeenDraw& draw, const SeenCut& cut,
                                      double image_height) noexcept;

}  // namespace clipc::runtime
