// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "runtime/matrix.h"
#include "runtime/projection_shape.h"
#include "runtime/status.h"

// One clip plane without any clip plane hardware: the projection's z column is replaced so that the
// near plane *is* the clip plane. After NVIDIA's white paper WP-01386-001, "Custom Clip Plane Using
// Near Clip Plane Shearing", and Lengyel, "Oblique View Frustum Depth Projection and Clipping".
//
// The paper multiplies the projection by a matrix with the clip-space plane C_P in its z column.
// Multiplied out, that column is the plane before the projection, times a scale: z' = a Dot(plane,
// v). So it is written there, and no digit is lost.
//
// It works where the eye is strictly on the clipped side; there it resolves depth at least as well
// as a near plane at a|Cw|. What it costs anywhere: only one plane; nothing is clipped at the
// projection's own near plane, so geometry between the eye and it must not be on the kept side;
// depth values cannot be compared with those of other projections.
namespace clipc::runtime {

enum class NearPlaneScale {
  kAsGiven,  // a = 1, the paper's: the length of the plane decides what the far plane loses
  // Lengyel's: the largest a that loses nothing at the far plane, min over the frustum's corners of
  // w / Dot(plane, v)
  kKeepFar,
};

struct ShearedProjection {
  Matrix projection;
  double scale = 0;  // a
  // a |Cw|, for a perspective: depth is resolved as by a projection with its near plane at this
  // clip-space w. 0 if orthographic.
  double effective_near = 0;
  // How many times faster depth grows than with the given projection: what is left of its
  // precision.
  double depth_ratio = 0;
  bool keeps_far =
      false;  // nothing inside the frustum is lost at the far plane; always with kKeepFar
};

// The smallest depth_ratio for an orthographic projection: of 24 bits, 16 are left.
inline constexpr double kMinOrthographicDepthRatio = 0x1p-8;

// The projection whose near plane is `view_plane`. Never flips the plane: that would keep the other
// half. Errors: kWrongProjection unless ShapeOf holds and agrees with `range`; kEyeNotClipped
// unless the eye (of an orthographic projection: the direction to the viewer) is strictly on the
// clipped side; kNoDepthLeft unless a|Cw| is at least the projection's near distance (orthographic:
// depth_ratio at least kMinOrthographicDepthRatio); kSingular; kNotFinite. The zero plane is an eye
// that is not clipped: it would give every point the same depth.
Result<ShearedProjection> ShearNearPlane(const Plane& view_plane, const Matrix& projection,
                                         DepthRange range, NearPlaneScale scale) noexcept;

// Writes the z column of a matrix from any space to clip space, given the plane in that same space
// and a scale from ShearNearPlane: z' = a d; for reversed depth w - a d; for -1..1 2 a d - w and w
// - 2 a d. Best with the object-space plane (PlaneBefore) and the whole world * view * projection:
// then float arithmetic in the shader is as accurate as it can be.
void SetDepthColumn(Matrix& to_clip, const Plane& plane, double scale, DepthRange range) noexcept;

// The smallest difference in distance that a fixed-point depth buffer resolves at `distance` behind
// a perspective with its near plane at `effective_near`: distance^2 / (effective_near * 2^bits), in
// the unit of both.
double DepthStep(double effective_near, double distance, int depth_bits) noexcept;

}  // namespace clipc::runtime
