// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>

#include "clip_plane.h"
#include "matrix.h"
#include "status.h"
#include "table.h"

/// One call turns a plane as the application knows it into the constant that a shader's clip table
/// asks for; another predicts what the choice of the plane space costs in pixels. Pure functions:
/// any thread, no allocation.
namespace clipc::runtime {

/// The space in which the application knows a plane.
enum class KnownIn : std::uint8_t { kObject, kWorld, kView };

/// The order in which float multiplies the matrices and the vertex: each rounding loses digits of
/// what it rounds, and far from the world's origin the world's coordinates are large. Matrices that
/// the application multiplies in double and rounds once count as one.
enum class MatrixOrder : std::uint8_t {
  kOneMatrix,            ///< mul(v, world_view_projection)
  kWorldFirst,           ///< mul(mul(v, world), view_projection)
  kWorldViewFirst,       ///< mul(mul(v, world_view), projection): no world's coordinates in float
  kThreeMatrices,        ///< mul(mul(mul(v, world), view), projection)
  kFloatWorldView,       ///< one matrix, multiplied in float: (world view) projection
  kFloatViewProjection,  ///< one matrix, multiplied in float: world (view projection), as of glm's
                         ///< projection * view * model and of a view_projection for each frame
};

/// The matrices of one draw: clip = v * world * view * projection. A matrix that a conversion does
/// not need may stay the identity: from a world-space plane, xyw1 and clip need view and
/// projection, object needs world alone.
struct DrawMatrices {
  Matrix world, view, projection;
  MatrixOrder order = MatrixOrder::kOneMatrix;
};

/// The part of a cut that an image shows.
struct SeenCut {
  /// Places of the cut in the object's own space, spread evenly over the image: x, y and z of
  /// each.
  const double* places = nullptr;
  std::size_t count = 0;
  double edge = 0.1;  ///< the length of the triangles' edges, in half images
};

/// What the displacement of a cut is measured against.
enum class JudgedIn : std::uint8_t {
  kImage,    ///< its right place in the image: what one sees
  kSurface,  ///< its right place on the surface as it is drawn, wherever its vertices are
};

/// The image that the draw goes to, in which errors are measured.
struct Image {
  double height = 1080;      ///< rows of pixels
  double most_pixels = 0.5;  ///< the largest displacement of an edge without a warning, in pixels
  JudgedIn judged_in = JudgedIn::kImage;  ///< what that displacement is
};

struct SpaceConstant {
  PlaneConstant plane;  ///< plane.constant is for the shader's constant buffer
  /// PredictEdgeError of the space, in pixels along the surface, for an object around its own
  /// origin; 0 if there is no prediction. Where DrawMatrices::order has the world's coordinates in
  /// float, it counts the distance from the world's origin.
  double edge_error = 0;
  /// ok(), or kIllConditioned with a sentence if the displacement exceeds image.most_pixels. The
  /// constant is then as good as the space allows, and another space or order is better.
  Status warning;
  /// How far float displaces the object's vertices in the image, in pixels, and the cut with them;
  /// 0 if there is no prediction. With edge_error it makes sqrt(edge_error^2 + vertex_error^2) in
  /// the image.
  double vertex_error = 0;
};

/// The constant for plane space `space`: every float4 position p of that space (see PlaneSpace) has
/// dot(p, constant) equal to the plane's value at the vertex. Computed in double, with twice its
/// digits from one matrix to the next, and rounded once: right at any distance from the world's
/// origin.
/// Errors: those of ClipPlaneFromWorld, Xyw1PlaneFromView and ObjectPlaneFromWorld; in particular
/// kWrongProjection for xyw1 under a projection that is not a perspective: w is constant there, so
/// (x, y, w, 1) does not contain the depth of a vertex. Compile such draws with --plane-space=clip,
/// which loses nothing under such a projection, or with object.
Result<SpaceConstant> PlaneConstantFor(PlaneSpace space, const Plane& plane, KnownIn known_in,
                                       const DrawMatrices& draw, const Image& image = {}) noexcept;

/// The sine that stands for surfaces of every direction: surfaces that meet a plane at random
/// angles from 3 degrees up have, at the 99th percentile, the error of a surface at this sine.
inline constexpr double kAnySurface = 0.1;

/// The reach of an object as large as the image is high, around its own origin.
inline constexpr double kAroundOrigin = 0.5;

/// The 99th percentile of the distance, in pixels, by which float arithmetic in the vertex shader
/// displaces the edge that the plane cuts into a surface, along the surface as it is drawn: the
/// surface's own displacement is not in it. `sine` is the sine of the angle between
/// surface and plane, 1 if they are perpendicular. With e = 2^-24 H/2 / sine of an image of H
/// rows, the plane (N, Cw) with a unit normal, the elements of ProjectionShape, the reach R, o = 1
/// + 2 |(ox, oy)|, K = |Nz - ox Nx/Px - oy Ny/Py| and t = 1 + 2 |(tx, ty)|:
///
///   xyw1                  e (o + K Py + 2 R)
///   clip, perspective     e (o + K Py + 2 R + 1.4 |Cw| |A/B| (Py + 2 R))
///   clip, orthographic    e (t + 2 R + Py max(|Cw|, |Nz| |B/A|))
///   object                e 1.5 R, with an R of at least a tenth
///
/// |A/B| is 1/n for standard depth from 0 to 1, 1/2n where z goes from -1 to 1, reversed or not,
/// and 0 or 1/f for reversed depth from 1 to 0; |B/A| is n for standard depth, f for reversed.
///
/// `reach` is how far the cut is from the origin of a space in which the shader has the vertices in
/// float, in heights of the image at the cut's depth; the farthest of these spaces counts. One is
/// the object's own: a level or a terrain whose vertices are in world coordinates has a large
/// reach, and so has a part of it that is near the eye. For `clip` and `xyw1` another is the world,
/// of the orders kWorldFirst and kFloatViewProjection. Of kThreeMatrices and kFloatWorldView, where
/// the view cancels what is large before z and w are made, the law is that of `xyw1` with the
/// world's reach, of `clip` under an orthographic projection, or that of the space with the
/// object's, whichever is more.
///
/// A law knows neither the object's matrix nor where in the image the cut is: a plane whose
/// normal is an axis of the object loses less than it says, and a corner of the cut that is much
/// nearer than the rest may lose more. The laws hold for triangles smaller than the image; the
/// error of larger ones grows in proportion. Errors: kLooksTransposed; kWrongProjection unless
/// ShapeOf holds, and for xyw1 without a perspective; kSingular if the plane has no normal or the
/// projection has no inverse; kNotFinite unless height and sine are positive and finite, reach is
/// not negative, and plane, projection and the error are finite.
Result<double> PredictEdgeError(PlaneSpace space, const Plane& view_plane, const Matrix& projection,
                                double image_height, double sine = kAnySurface,
                                double reach = kAroundOrigin) noexcept;

/// The displacements of a cut's edge, in pixels: each is a 99th percentile.
struct EdgeDisplacement {
  double along_surface = 0;  ///< along the surface as it is drawn: PredictEdgeError
  double of_vertices = 0;    ///< of the surface's places in the image, which take the cut with them
  double in_image = 0;       ///< of the cut in the image: both together

  double In(JudgedIn where) const noexcept {
    return where == JudgedIn::kImage ? in_image : along_surface;
  }
};

/// The edge error of one draw, along its surface, followed from its own matrices and places of its
/// cut through each rounding of the shader to the image, which takes up to a millisecond for 256
/// places, the most that count. `plane` is known in `known_in`. Tests in study/ compare it with
/// __float128 over 10,000 draws of each order of matrices, up to 20 pixels, by which an edge is too
/// short: what 20 neighbouring views of a draw lose is 0.2 to 3 times it in all but a few
/// (docs/laws.md). Errors: as above, and those of PlaneConstantFor; kInvalidArgument unless a
/// place of the cut lies before the eye and the edges have a length.
Result<double> PredictEdgeError(PlaneSpace space, const Plane& plane, KnownIn known_in,
                                const DrawMatrices& draw, const SeenCut& cut, double image_height,
                                double sine = kAnySurface) noexcept;

/// The same, and what the image shows of it, in twice the time: the position of a vertex goes
/// through draw.order in float too. Far from the world's origin, space `object` keeps the cut where
/// it belongs on the surface under every order, but the surface itself is displaced. Errors: as
/// above.
Result<EdgeDisplacement> PredictEdgeDisplacement(PlaneSpace space, const Plane& plane,
                                                 KnownIn known_in, const DrawMatrices& draw,
                                                 const SeenCut& cut, double image_height,
                                                 double sine = kAnySurface) noexcept;

}  // namespace clipc::runtime
