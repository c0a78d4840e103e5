// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/clip_plane.h"

#include "runtime/finite.h"
#include "runtime/plane_chain.h"
#include "runtime/projection_shape.h"

namespace clipc::runtime {
Result<Float4> RoundPlane(const Plane& plane) noexcept {
  if (!IsFinite(plane)) {
    return Status::Failure(Error::kNotFinite, "the plane is (%g, %g, %g, %g)", plane.x, plane.y,
                           plane.z, plane.w);
  }
  const double largest = LargestOf({plane.x, plane.y, plane.z, plane.w});
  if (largest != 0 && (largest < static_cast<double>(kMinPlaneScale) ||
                       largest > static_cast<double>(kMaxPlaneScale))) {
    return Status::Failure(Error::kNotRepresentable,
                           "the plane's largest component is %.3g; scale the plane", largest);
  }
  return Float4{static_cast<float>(plane.x), static_cast<float>(plane.y),
                static_cast<float>(plane.z), static_cast<float>(plane.w)};
}

Result<PlaneConstant> ClipPlaneFromView(const Plane& view_plane,
                                        const Matrix& projection) noexcept {
  return Finish(ThroughProjection(Begin(view_plane), projection));
}

Result<PlaneConstant> ClipPlaneFromWorld(const Plane& world_plane, const Matrix& view,
                                         const Matrix& projection) noexcept {
  return Finish(ThroughProjection(Through(Begin(world_plane), view, "view"), projection));
}

Result<PlaneConstant> ClipPlaneFromObject(const Plane& object_plane, const Matrix& world,
                                          const Matrix& view, const Matrix& projection) noexcept {
  const Step in_world = Through(Begin(object_plane), world, "world");
  return Finish(ThroughProjection(Through(in_world, view, "view"), projection));
}

Result<PreparedCamera> PrepareCamera(const Matrix& view, const Matrix& projection) noexcept {
  if (Status status = CheckAffine(view, "view"); !status.ok()) return status;
  if (Status status = CheckProjection(projection); !status.ok()) return status;
  return PreparedCamera{view, projection, InverseOfAffine(view), ShapeOf(projection)};
}

Result<PlaneConstant> ClipPlaneFromWorld(const Plane& world_plane,
                                         const PreparedCamera& camera) noexcept {
  return Finish(ThroughCamera(Begin(world_plane), camera));
}

Result<PlaneConstant> ClipPlaneFromObject(const Plane& object_plane, const Matrix& world,
                                          const PreparedCamera& camera) noexcept {
  return Finish(ThroughCamera(Through(Begin(object_plane), world, "world"), camera));
}

Result<PlaneConstant> ViewPlaneFromWorld(const Plane& world_plane, const Matrix& view) noexcept {
  return Finish(Through(Begin(world_plane), view, "view"));
}

Result<PlaneConstant> DocumentClipPlane(const Plane& view_plane,
                                        const Matrix& projection) noexcept {
  const Step begin = Begin(view_plane);
  if (!begin.ok()) return begin.status;
  if (const Status status = CheckProjection(projection); !status.ok()) return status;
  const ProjectionShape s = ShapeOf(projection);
  if (!s.is_perspective() || s.e != 1 || s.ox != 0 || s.oy != 0 || s.tx != 0 || s.ty != 0 ||
      s.b == 0) {
    return Status::Failure(
        Error::kWrongProjection,
        "the closed form is for [Px 0 0 0; 0 Py 0 0; 0 0 A 1; 0 0 B 0]; use ClipPlaneFromView");
  }
  return Finish(ThroughShape(begin.value, s));
}

Result<PlaneConstant> Xyw1PlaneFromView(const Plane& view_plane,
                                        const Matrix& projection) noexcept {
  return Finish(ToXyw1(Begin(view_plane), projection));
}

Result<PlaneConstant> ObjectPlaneFromWorld(const Plane& world_plane, const Matrix& world) noexcept {
  return Finish(Before(Begin(world_plane), world, "world"));
}

}  // namespace clipc::runtime
