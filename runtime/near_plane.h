// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "matrix.h"
#include "projection_shape.h"
#include "status.h"

/// One clip plane without any clip plane hardware: the projection's z column is replaced so that
/// the near plane *is* the clip plane. Sources: NVIDIA's white paper WP-01386-001, "Custom Clip
/// Plane Using Near Clip Plane Shearing"; Lengyel, "Oblique View Frustum Depth Projection and
/// Clipping".
///
/// The white paper multiplies the projection by a matrix with the clip-space plane C_P in its z
/// column. The z column of that product is the plane before the projection, times a scale: z' = a
/// Dot(plane, v). This column is written directly, so that no digit is lost.
///
/// The eye must be strictly on the clipped side; depth is then resolved at least as well as by a
/// near plane at a|Cw|. The price: there is only one plane; nothing is clipped at the projection's
/// own near plane, so geometry between it and the eye must not be on the kept side; depth values
/// cannot be compared with those of other projections.
namespace clipc::runtime {

enum class NearPlaneScale {
  /// NVIDIA's a = 1: the length of the plane's normal decides how much the far plane cuts off.
  kAsGiven,
  /// Lengyel's a, the largest with which the far plane cuts nothing off: the minimum over the
  /// frustum's corners of w / Dot(plane, v).
  kKeepFar,
};

struct ShearedProjection {
  Matrix projection;
  double scale = 0;  ///< a
  /// a |Cw| for a perspective: depth is resolved as by a projection with its near plane at this
  /// clip-space w; the smallest difference in distance that n bits of depth resolve at distance s
  /// is s^2 / (effective_near * 2^n). 0 if orthographic.
  double effective_near = 0;
  /// The growth of depth along a line of sight, relative to the given projection: the part of its
  /// precision that is left.
  double depth_ratio = 0;
  /// The far plane cuts off nothing inside the frustum; true with kKeepFar.
  bool keeps_far = false;
};

/// The smallest depth_ratio for an orthographic projection: of 24 bits, 16 are left.
inline constexpr double kMinOrthographicDepthRatio = 0x1p-8;

/// The projection whose near plane is `view_plane`. The plane is never flipped, which would keep
/// the other half. Errors:
///
///   kWrongProjection   unless ShapeOf holds and agrees with `range`
///   kEyeNotClipped     unless the eye (orthographic: the direction to the viewer) is strictly on
///                      the clipped side; also for the zero plane, which gives every point one
///                      depth
///   kNoDepthLeft       unless a|Cw| is at least the projection's near distance (orthographic:
///                      unless depth_ratio is at least kMinOrthographicDepthRatio)
///   kSingular, kNotFinite, kLooksTransposed, kIllConditioned, kNotRepresentable
///                      as ClipPlaneFromView; kNotRepresentable also for a scale beyond a double
Result<ShearedProjection> ShearNearPlane(const Plane& view_plane, const Matrix& projection,
                                         DepthRange range, NearPlaneScale scale) noexcept;

/// Writes the z column of a matrix from any space to clip space, given the plane in that same space
/// and a scale a from ShearNearPlane. With d = Dot(plane, v):
///
///   depth 0 to 1     z' = a d          reversed    z' = w - a d
///   depth -1 to 1    z' = 2 a d - w    reversed    z' = w - 2 a d
///
/// Float arithmetic in the shader is most accurate with the object-space plane (PlaneBefore) and
/// the whole world * view * projection.
void SetDepthColumn(Matrix& to_clip, const Plane& plane, double scale, DepthRange range) noexcept;

}  // namespace clipc::runtime
