// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "affine_inverse.h"
#include "matrix.h"
#include "projection_shape.h"
#include "status.h"

/// Planes for shaders and devices: from the space in which an application knows a plane to the
/// constants that a vertex shader dots with its position. Computed in double, rounded to float
/// once. Pure functions: any thread, no allocation.
///
/// Every function reports kNotFinite if an argument contains NaN or infinity, and kLooksTransposed
/// for a matrix whose last row and column say that it is for column vectors: see LooksTransposed
/// and CheckProjection in projection_shape.h. The zero plane gives the zero constant.
namespace clipc::runtime {

/// A plane in another space.
struct PlaneConstant {
  Float4 constant;  ///< rounded, for the constant buffer or SetClipPlane
  Plane plane;      ///< the same before rounding, for further computation
  /// The error of `plane` is about condition * 2^-53 of its largest component.
  double condition = 0;
};

/// The largest condition at which the rounded constant is right to about one unit in the last place
/// of its largest component; above it the functions report kIllConditioned.
inline constexpr double kMaxCondition = 1 << 25;

/// The limits of the largest component of a constant, which may also be 0; outside them the
/// functions report kNotRepresentable. Below, the small components are denormal, which devices
/// flush to 0; above, the clipper's interpolation overflows.
inline constexpr float kMinPlaneScale = 0x1p-100f;
inline constexpr float kMaxPlaneScale = 0x1p112f;

/// Rounds `plane`. Errors: kNotFinite, kNotRepresentable.
Result<Float4> RoundPlane(const Plane& plane) noexcept;

/// The plane C_P in clip space, which [clipplanes] and SetClipPlane need:
/// dot(v * projection, C_P) == dot(v, view_plane) for every v. Solves projection * C_P = view_plane
/// for any invertible projection: perspective and orthographic, either handedness, either depth
/// range, reversed, infinite, off-centre, jittered; by a closed form if ShapeOf holds, else by
/// elimination. Errors: kSingular, kIllConditioned, kNotRepresentable.
Result<PlaneConstant> ClipPlaneFromView(const Plane& view_plane, const Matrix& projection) noexcept;

/// C_P for a plane in world space. Solves for view and projection one after the other, and
/// rounds nothing to double in between: no translation is too long.
Result<PlaneConstant> ClipPlaneFromWorld(const Plane& world_plane, const Matrix& view,
                                         const Matrix& projection) noexcept;

/// C_P for a plane in the object's own space.
Result<PlaneConstant> ClipPlaneFromObject(const Plane& object_plane, const Matrix& world,
                                          const Matrix& view, const Matrix& projection) noexcept;

/// A camera, with what does not depend on the plane: prepared once a frame, for the planes of many
/// objects. Its members may be read, and PrepareCamera alone sets them.
struct PreparedCamera {
  Matrix view, projection;
  AffineInverse view_inverse;
  ProjectionShape shape;  ///< of the projection
};

/// Errors: kNotFinite, kLooksTransposed. A matrix that has no inverse is reported with the first
/// plane.
Result<PreparedCamera> PrepareCamera(const Matrix& view, const Matrix& projection) noexcept;

/// ClipPlaneFromWorld and ClipPlaneFromObject for a prepared camera: the same results bit for bit,
/// and several times faster.
Result<PlaneConstant> ClipPlaneFromWorld(const Plane& world_plane,
                                         const PreparedCamera& camera) noexcept;
Result<PlaneConstant> ClipPlaneFromObject(const Plane& object_plane, const Matrix& world,
                                          const PreparedCamera& camera) noexcept;

/// A world-space plane in view space. `view` may contain a mirror. Errors: those of
/// ClipPlaneFromView.
Result<PlaneConstant> ViewPlaneFromWorld(const Plane& world_plane, const Matrix& view) noexcept;

/// The closed form of Microsoft's "User clip planes on feature level 9 hardware", section "Clip
/// space clip plane": C_P = (Cx/Px, Cy/Py, Cw/B, Cz - Cw A/B). Only for the matrix of that section,
/// [Px 0 0 0; 0 Py 0 0; 0 0 A 1; 0 0 B 0]: a left-handed, centred perspective with either depth
/// range, reversed or not, infinite or not. Errors: kWrongProjection for any other matrix.
Result<PlaneConstant> DocumentClipPlane(const Plane& view_plane, const Matrix& projection) noexcept;

/// The constant K for plane space `xyw1`: dot(float4(pos.xy, pos.w, 1), K) == dot(v, view_plane)
/// for pos = v * projection. K = (Cx/Px, Cy/Py, (Cz - ox Cx/Px - oy Cy/Py)/e, Cw). K does not use
/// z, and so is a thousand times more accurate than C_P if depth is not reversed. Errors:
/// kWrongProjection unless ShapeOf finds a perspective with tx = ty = 0; under an orthographic
/// projection C_P is as accurate.
Result<PlaneConstant> Xyw1PlaneFromView(const Plane& view_plane, const Matrix& projection) noexcept;

/// The constant C_obj for plane space `object`, the most accurate space:
/// dot(v, C_obj) == dot(v * world, world_plane). C_obj = world * world_plane; `world` need not be
/// invertible. For a view-space plane, pass world * view.
Result<PlaneConstant> ObjectPlaneFromWorld(const Plane& world_plane, const Matrix& world) noexcept;

}  // namespace clipc::runtime
