// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/clip_plane.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "runtime/linear_solve.h"
#include "runtime/projection_shape.h"

namespace clipc::runtime {
namespace {

constexpr double kFloatRoundoff = 0x1p-24;

double LargestOf(std::initializer_list<double> numbers) {
  double largest = 0;
  for (const double number : numbers) largest = std::max(largest, std::fabs(number));
  return largest;
}

bool IsFinite(const Plane& plane) {
  return std::isfinite(plane.x) && std::isfinite(plane.y) && std::isfinite(plane.z) &&
         std::isfinite(plane.w);
}

bool IsFinite(const Matrix& matrix) {
  for (const auto& row : matrix.m) {
    for (const double element : row) {
      if (!std::isfinite(element)) return false;
    }
  }
  return true;
}

// A plane on its way through several spaces.
struct Step {
  Status status;
  Plane plane;
  Plane error;  // of each component, in units of 2^-53
};

Step Begin(const Plane& plane) {
  Step step{{}, plane, {}};
  if (!IsFinite(plane))
    step.status =
        Status::Failure(Error::kNotFinite, "the plane has a coefficient that is not finite");
  return step;
}

// The plane after `matrix`, whose inverse must exist; `name` is for the message.
Step Through(const Step& before, const Matrix& matrix, const char* name) {
  if (!before.status.ok()) return before;
  Step after;
  if (!IsFinite(matrix)) {
    after.status =
        Status::Failure(Error::kNotFinite, "the %s matrix has an element that is not finite", name);
    return after;
  }
  const Plane &b = before.plane, &e = before.error;
  const Solution solution = SolveLinear(matrix.m, {b.x, b.y, b.z, b.w}, {e.x, e.y, e.z, e.w});
  if (solution.singular) {
    after.status = Status::Failure(Error::kSingular, "the %s matrix has no inverse", name);
    return after;
  }
  after.plane = {solution.x[0], solution.x[1], solution.x[2], solution.x[3]};
  after.error = {solution.error[0], solution.error[1], solution.error[2], solution.error[3]};
  return after;
}

// The closed form for the shape in projection_shape.h: row i of the matrix times C_P is component i
// of the plane before.
Step ThroughShape(const Step& before, const ProjectionShape& s) {
  const Plane &c = before.plane, &ce = before.error;
  Step after;
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
  if (!before.status.ok()) return before;
  const ProjectionShape shape = ShapeOf(projection);
  if (!shape.holds) return Through(before, projection, "projection");
  if ((shape.is_perspective() ? shape.b : shape.a) == 0) {
    Step failed;
    failed.status = Status::Failure(
        Error::kSingular, "the projection matrix has no inverse: its depth does not depend on z");
    return failed;
  }
  return ThroughShape(before, shape);
}

Result<PlaneConstant> Finish(const Step& step) {
  Result<PlaneConstant> result;
  result.status = step.status;
  if (!result.status.ok()) return result;
  const Plane& plane = step.plane;
  const double largest = LargestOf({plane.x, plane.y, plane.z, plane.w});
  const double condition =
      largest == 0 ? 0
                   : LargestOf({step.error.x, step.error.y, step.error.z, step.error.w}) / largest;
  if (condition > kMaxCondition) {
    result.status = Status::Failure(
        Error::kIllConditioned, "the plane is not right to float precision: its condition is %.2g",
        condition);
    return result;
  }
  const Result<Float4> rounded = RoundPlane(plane);
  result.status = rounded.status;
  if (result.status.ok()) result.value = {rounded.value, plane, condition};
  return result;
}

Result<PlaneConstant> Fail(Error error, const char* what) {
  return {{}, Status::Failure(error, "%s", what)};
}

}  // namespace

Result<Float4> RoundPlane(const Plane& plane) noexcept {
  Result<Float4> result;
  if (!IsFinite(plane)) {
    result.status = Status::Failure(Error::kNotFinite, "the plane is (%g, %g, %g, %g)", plane.x,
                                    plane.y, plane.z, plane.w);
    return result;
  }
  const double largest = LargestOf({plane.x, plane.y, plane.z, plane.w});
  if (largest != 0 && (largest < static_cast<double>(kMinPlaneScale) ||
                       largest > static_cast<double>(kMaxPlaneScale))) {
    result.status =
        Status::Failure(Error::kNotRepresentable,
                        "the plane's largest component is %.3g; scale the plane", largest);
    return result;
  }
  result.value = {static_cast<float>(plane.x), static_cast<float>(plane.y),
                  static_cast<float>(plane.z), static_cast<float>(plane.w)};
  return result;
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
    return Fail(
        Error::kWrongProjection,
        "the closed form is for [Px 0 0 0; 0 Py 0 0; 0 0 A 1; 0 0 B 0]; use ClipPlaneFromView");
  }
  const Step begin = Begin(view_plane);
  return Finish(begin.status.ok() ? ThroughShape(begin, s) : begin);
}

Result<PlaneConstant> Xyw1PlaneFromView(const Plane& view_plane,
                                        const Matrix& projection) noexcept {
  const ProjectionShape s = ShapeOf(projection);
  if (!s.is_perspective() || s.tx != 0 || s.ty != 0) {
    return Fail(Error::kWrongProjection,
                "plane space xyw1 needs a perspective; for others plane space clip is as accurate");
  }
  Step step = Begin(view_plane);
  if (!step.status.ok()) return Finish(step);
  const double x = view_plane.x / s.px, y = view_plane.y / s.py;
  step.plane = {x, y, (view_plane.z - s.ox * x - s.oy * y) / s.e, view_plane.w};
  step.error = {std::fabs(x), std::fabs(y),
                std::fabs(step.plane.z) +
                    (std::fabs(view_plane.z) + 3 * std::fabs(s.ox * x) + 3 * std::fabs(s.oy * y)) /
                        std::fabs(s.e),
                0};
  return Finish(step);
}

Result<PlaneConstant> ObjectPlaneFromWorld(const Plane& world_plane, const Matrix& world) noexcept {
  if (!IsFinite(world))
    return Fail(Error::kNotFinite, "the world matrix has an element that is not finite");
  Step step = Begin(world_plane);
  if (!step.status.ok()) return Finish(step);
  step.plane = PlaneBefore(world, world_plane);
  const Plane& p = step.plane;
  step.error = {std::fabs(p.x), std::fabs(p.y), std::fabs(p.z), std::fabs(p.w)};
  return Finish(step);
}

Result<double> ClipSpaceEdgeError(const Plane& view_plane, const Matrix& projection,
                                  double picture_height) noexcept {
  const ProjectionShape s = ShapeOf(projection);
  const double length = NormalLength(view_plane);
  if (!s.holds)
    return {0, Status::Failure(Error::kWrongProjection,
                               "the projection is neither a perspective nor orthographic")};
  if (!(length > 0) || (s.is_perspective() ? s.b : s.a) == 0)
    return {0, Status::Failure(Error::kSingular,
                               "the plane has no normal, or the projection no inverse")};
  const double amplified = s.is_perspective() ? view_plane.w * s.a / s.b : view_plane.z * s.b / s.a;
  return {20 * kFloatRoundoff * std::fabs(amplified * s.py) * picture_height / (2 * length), {}};
}

}  // namespace clipc::runtime
