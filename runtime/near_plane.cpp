// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/near_plane.h"

#include <algorithm>
#include <cmath>

#include "runtime/clip_plane.h"

namespace clipc::runtime {
namespace {

// Room for the rounding of numbers that are equal by construction.
constexpr double kSlack = 1e-9;

// Dot(clip_plane, corner) at the corner of the clip-space cube where it is largest; corners have w
// = 1, those at infinity too.
double LargestAtACorner(const Plane& clip_plane, DepthRange range) {
  const double low = range.negative_one_to_one ? -1 : 0;
  return std::fabs(clip_plane.x) + std::fabs(clip_plane.y) +
         std::max(low * clip_plane.z, clip_plane.z) + clip_plane.w;
}

// The span of z/w over the whole depth range: 1 or 2.
double DepthSpan(DepthRange range) { return range.negative_one_to_one ? 2 : 1; }

Status CheckEye(const ProjectionShape& shape, double depth_slope, double view_w) {
  if (depth_slope > 0) return {};
  return shape.is_perspective()
             ? Status::Failure(
                   Error::kEyeNotClipped,
                   "the eye is %g in front of the plane; it must be on the clipped side", view_w)
             : Status::Failure(Error::kEyeNotClipped,
                               "the plane does not face away from the viewer");
}

Status CheckDepth(const ProjectionShape& shape, DepthRange range,
                  const ShearedProjection& sheared) {
  if (shape.is_orthographic()) {
    if (sheared.depth_ratio >= kMinOrthographicDepthRatio * (1 - kSlack)) return {};
    return Status::Failure(Error::kNoDepthLeft,
                           "%.3g of the depth precision is left; at least %.3g must be",
                           sheared.depth_ratio, kMinOrthographicDepthRatio);
  }
  const double near = NearW(shape, range);
  if (sheared.effective_near >= near * (1 - kSlack)) return {};
  return Status::Failure(
      Error::kNoDepthLeft,
      "depth would be resolved as with a near plane at %.3g; the projection's is at %.3g",
      sheared.effective_near, near);
}

}  // namespace

Result<ShearedProjection> ShearNearPlane(const Plane& view_plane, const Matrix& projection,
                                         DepthRange range, NearPlaneScale scale) noexcept {
  if (Status status = CheckProjection(projection); !status.ok()) return status;
  const ProjectionShape shape = ShapeOf(projection);
  if (!shape.holds) {
    return Status::Failure(Error::kWrongProjection,
                           "the projection is neither a perspective nor orthographic");
  }
  if (shape.is_perspective() && (range.reversed ? shape.b < 0 : shape.b > 0)) {
    return Status::Failure(Error::kWrongProjection, "the projection's depth is %sreversed",
                           range.reversed ? "not " : "");
  }
  const Result<PlaneConstant> clip = ClipPlaneFromView(view_plane, projection);
  if (!clip.ok()) return clip.status;
  const Plane& clip_plane = clip.value.plane;

  // Along a line of sight x/w and y/w are constant, so this is how d/w grows with the given depth.
  // For a perspective it is -d(eye)/n up to a positive factor: the eye is the point (0, 0, b, 0) of
  // clip space.
  const double depth_slope = DepthSpan(range) * (range.reversed ? -clip_plane.z : clip_plane.z);
  const double at_eye = shape.b * clip_plane.z;
  if (Status status = CheckEye(shape, depth_slope, at_eye); !status.ok()) return status;

  ShearedProjection sheared;
  const double largest = LargestAtACorner(clip_plane, range);
  sheared.scale = 1;
  if (scale == NearPlaneScale::kKeepFar) {
    // A plane that clips the whole frustum leaves the scale open; depth stays as steep as it was.
    sheared.scale = largest > 0 ? 1 / largest : 1 / depth_slope;
  }
  if (!std::isfinite(sheared.scale)) {
    return Status::Failure(Error::kNotRepresentable,
                           "the plane is too short for a near plane: its scale is beyond a double");
  }
  sheared.keeps_far = sheared.scale * largest <= 1 + kSlack;
  sheared.depth_ratio = sheared.scale * depth_slope;
  if (shape.is_perspective()) sheared.effective_near = sheared.scale * std::fabs(at_eye);
  if (Status status = CheckDepth(shape, range, sheared); !status.ok()) return status;
  sheared.projection = projection;
  SetDepthColumn(sheared.projection, view_plane, sheared.scale, range);
  return sheared;
}

void SetDepthColumn(Matrix& to_clip, const Plane& plane, double scale, DepthRange range) noexcept {
  const double coefficients[4] = {plane.x, plane.y, plane.z, plane.w};
  for (int row = 0; row < 4; ++row) {
    const double depth = DepthSpan(range) * scale * coefficients[row];
    const double w = to_clip.m[row][3];
    to_clip.m[row][2] = range.reversed ? w - depth : range.negative_one_to_one ? depth - w : depth;
  }
}

}  // namespace clipc::runtime
