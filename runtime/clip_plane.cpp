// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/clip_plane.h"

#include <algorithm>
#include <cmath>

#include "runtime/linear_solve.h"
#include "runtime/projection_shape.h"

namespace clipc::runtime {
namespace {

constexpr double kFloatRoundoff = 0x1p-24;

Plane Magnitude(const Plane& p) {
  return {std::fabs(p.x), std::fabs(p.y), std::fabs(p.z), std::fabs(p.w)};
}

double LargestOf(const Plane& plane) {
  const Plane size = Magnitude(plane);
  return std::max({size.x, size.y, size.z, size.w});
}

bool IsFinite(const Plane& plane) {
  return std::isfinite(plane.x) && std::isfinite(plane.y) && std::isfinite(plane.z) &&
         std::isfinite(plane.w);
}

bool IsFinite(const Matrix& matrix) {
  return std::all_of(&matrix.m[0][0], &matrix.m[0][0] + 16,
                     [](double element) { return std::isfinite(element); });
}

// A plane on its way through several spaces.
struct Bounded {
  Plane plane;
  Plane error;  // of each component, in units of 2^-53
};
using Step = Result<Bounded>;

Step Begin(const Plane& plane) {
  if (IsFinite(plane)) return Bounded{plane, {}};
  return Status::Failure(Error::kNotFinite, "the plane has a coefficient that is not finite");
}

// The plane after `matrix`, whose inverse must exist; `name` is for the message.
Step Through(const Step& before, const Matrix& matrix, const char* name) {
  if (!before.ok()) return before;
  if (!IsFinite(matrix)) {
    return Status::Failure(Error::kNotFinite, "the %s matrix has an element that is not finite",
                           name);
  }
  const auto& [b, e] = before.value;
  const Solution solution = SolveLinear(matrix.m, {b.x, b.y, b.z, b.w}, {e.x, e.y, e.z, e.w});
  if (solution.singular)
    return Status::Failure(Error::kSingular, "the %s matrix has no inverse", name);
  const auto plane_of = [](const double(&x)[4]) { return Plane{x[0], x[1], x[2], x[3]}; };
  return Bounded{plane_of(solution.x), plane_of(solution.error)};
}

// The closed form for the shape in projection_shape.h: row i of the matrix times C_P is component i
// of the plane before.
Step ThroughShape(const Step& before, const ProjectionShape& s) {
  if (!before.ok()) return before;
  const Plane &c = before.value.plane, &ce = before.value.error;
  Bounded after;
  Plane &p = after.plane, &e = after.error;
  p.x = c.x / s.px;
  p.y = c.y / s.py;
  e.x = std::fabs(p.x) + ce.x / std::fabs(s.px);
  e.y = std::fabs(p.y) + ce.y / std::fabs(s.py);
  // Row 2: ox x + oy y + a z + e w = c.z. Row 3: tx x + ty y + b z + g w = c.w.
  const auto rest = [&](double c_i, double o_x, double o_y) { return c_i - o_x * p.x - o_y * p.y; };
  const auto rest_error = [&](double c_i, double c_error, double o_x, double o_y) {
    return std::fabs(c_i) + c_error + std::fabs(o_x) * (std::fabs(p.x) + e.x) +
           std::fabs(o_y) * (std::fabs(p.y) + e.y);
  };
  const double rest2 = rest(c.z, s.ox, s.oy), error2 = rest_error(c.z, ce.z, s.ox, s.oy);
  const double rest3 = rest(c.w, s.tx, s.ty), error3 = rest_error(c.w, ce.w, s.tx, s.ty);
  if (s.is_perspective()) {
    p.z = rest3 / s.b;
    e.z = std::fabs(p.z) + error3 / std::fabs(s.b);
    p.w = (rest2 - s.a * p.z) / s.e;
    e.w = std::fabs(p.w) + (error2 + std::fabs(s.a) * (std::fabs(p.z) + e.z)) / std::fabs(s.e);
  } else {
    p.z = rest2 / s.a;
    e.z = std::fabs(p.z) + error2 / std::fabs(s.a);
    p.w = (rest3 - s.b * p.z) / s.g;
    e.w = std::fabs(p.w) + (error3 + std::fabs(s.b) * (std::fabs(p.z) + e.z)) / std::fabs(s.g);
  }
  return after;
}

Step ThroughProjection(const Step& before, const Matrix& projection) {
  const ProjectionShape shape = ShapeOf(projection);
  if (!shape.holds) return Through(before, projection, "projection");
  if (before.ok() && (shape.is_perspective() ? shape.b : shape.a) == 0) {
    return Status::Failure(Error::kSingular,
                           "the projection matrix has no inverse: its depth does not depend on z");
  }
  return ThroughShape(before, shape);
}

Result<PlaneConstant> Finish(const Step& step) {
  if (!step.ok()) return step.status;
  const auto& [plane, error] = step.value;
  const double largest = LargestOf(plane);
  const double condition = largest == 0 ? 0 : LargestOf(error) / largest;
  if (condition > kMaxCondition) {
    return Status::Failure(Error::kIllConditioned,
                           "the plane is not right to float precision: its condition is %.2g",
                           condition);
  }
  const Result<Float4> rounded = RoundPlane(plane);
  if (!rounded.ok()) return rounded.status;
  return PlaneConstant{rounded.value, plane, condition};
}

}  // namespace

Result<Float4> RoundPlane(const Plane& plane) noexcept {
  if (!IsFinite(plane)) {
    return Status::Failure(Error::kNotFinite, "the plane is (%g, %g, %g, %g)", plane.x, plane.y,
                           plane.z, plane.w);
  }
  const double largest = LargestOf(plane);
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

Result<PlaneConstant> ViewPlaneFromWorld(const Plane& world_plane, const Matrix& view) noexcept {
  return Finish(Through(Begin(world_plane), view, "view"));
}

Result<PlaneConstant> DocumentClipPlane(const Plane& view_plane,
                                        const Matrix& projection) noexcept {
  const ProjectionShape s = ShapeOf(projection);
  if (!s.is_perspective() || s.e != 1 || s.ox != 0 || s.oy != 0 || s.tx != 0 || s.ty != 0 ||
      s.b == 0) {
    return Status::Failure(
        Error::kWrongProjection,
        "the closed form is for [Px 0 0 0; 0 Py 0 0; 0 0 A 1; 0 0 B 0]; use ClipPlaneFromView");
  }
  return Finish(ThroughShape(Begin(view_plane), s));
}

Result<PlaneConstant> Xyw1PlaneFromView(const Plane& view_plane,
                                        const Matrix& projection) noexcept {
  const ProjectionShape s = ShapeOf(projection);
  if (!s.is_perspective() || s.tx != 0 || s.ty != 0) {
    return Status::Failure(
        Error::kWrongProjection,
        "plane space xyw1 needs a perspective; for others plane space clip is as accurate");
  }
  const Step begin = Begin(view_plane);
  if (!begin.ok()) return begin.status;
  const double x = view_plane.x / s.px, y = view_plane.y / s.py;
  const Plane plane = {x, y, (view_plane.z - s.ox * x - s.oy * y) / s.e, view_plane.w};
  Plane error = Magnitude(plane);
  error.z += (std::fabs(view_plane.z) + 3 * std::fabs(s.ox * x) + 3 * std::fabs(s.oy * y)) /
             std::fabs(s.e);
  error.w = 0;
  return Finish(Bounded{plane, error});
}

Result<PlaneConstant> ObjectPlaneFromWorld(const Plane& world_plane, const Matrix& world) noexcept {
  if (!IsFinite(world))
    return Status::Failure(Error::kNotFinite, "the world matrix has an element that is not finite");
  const Step begin = Begin(world_plane);
  if (!begin.ok()) return begin.status;
  const Plane plane = PlaneBefore(world, world_plane);
  return Finish(Bounded{plane, Magnitude(plane)});
}

Result<double> ClipSpaceEdgeError(const Plane& view_plane, const Matrix& projection,
                                  double picture_height) noexcept {
  const ProjectionShape s = ShapeOf(projection);
  const double length = NormalLength(view_plane);
  if (!s.holds)
    return Status::Failure(Error::kWrongProjection,
                           "the projection is neither a perspective nor orthographic");
  if (!(length > 0) || (s.is_perspective() ? s.b : s.a) == 0)
    return Status::Failure(Error::kSingular,
                           "the plane has no normal, or the projection no inverse");
  // An orthographic z is as large as the depth, and the plane's w as the eye is far: both are
  // rounded before they cancel.
  const double amplified =
      s.is_perspective() ? std::fabs(view_plane.w * s.a / s.b)
                         : std::fmax(std::fabs(view_plane.w), std::fabs(view_plane.z * s.b / s.a));
  return 20 * kFloatRoundoff * amplified * std::fabs(s.py) * picture_height / (2 * length);
}

}  // namespace clipc::runtime
