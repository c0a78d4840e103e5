// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/plane_chain.h"

#include <algorithm>
#include <cmath>

#include "runtime/finite.h"
#include "runtime/linear_solve.h"

namespace clipc::runtime {
namespace {

// The largest rounding error of a sum of four products of DoubleDoubles, in units of 2^-53.
constexpr double kRoundingOfProducts = 0x1p-48;

// The error that a quotient or a product of this size has from being rounded; none for an exact 0.
double RoundingOf(double result, double operand) {
  return operand == 0 ? 0 : std::fabs(result) + kUnderflow;
}

// A plane's components in double, with the error that rounding them adds.
void Round(const Bounded& bounded, double (&c)[4], double (&error)[4]) {
  for (int i = 0; i < 4; ++i) {
    c[i] = bounded.plane[i].high;
    error[i] = bounded.error[i] + (bounded.plane[i].low != 0 ? std::fabs(c[i]) : 0);
  }
}

// The plane after any matrix that has an inverse.
Step Eliminated(const Bounded& before, const Matrix& matrix, const char* name) {
  const Solution solution = SolveLinear(matrix.m, before.plane, before.error);
  if (solution.singular)
    return Status::Failure(Error::kSingular, "the %s matrix has no inverse", name);
  Bounded after;
  std::copy(solution.x, solution.x + 4, after.plane);
  std::copy(solution.error, solution.error + 4, after.error);
  return after;
}

// The plane after a projection that CheckProjection allows.
Step Projected(const Bounded& before, const Matrix& projection, const ProjectionShape& shape) {
  if (!shape.holds) return Through(before, projection, "projection");
  if ((shape.is_perspective() ? shape.b : shape.a) == 0) {
    return Status::Failure(Error::kSingular,
                           "the projection matrix has no inverse: its depth does not depend on z");
  }
  return ThroughShape(before, shape);
}

}  // namespace

Status CheckAffine(const Matrix& matrix, const char* name) noexcept {
  if (!IsFinite(matrix)) {
    return Status::Failure(Error::kNotFinite, "the %s matrix has an element that is not finite",
                           name);
  }
  if (LooksTransposed(matrix)) {
    return Status::Failure(Error::kLooksTransposed,
                           "the %s matrix looks transposed: its translation is in the last column, "
                           "not in the last row; see ColumnVectorMatrix",
                           name);
  }
  return {};
}

Plane Rounded(const Bounded& bounded) noexcept {
  const DoubleDouble* c = bounded.plane;
  return {c[0].high, c[1].high, c[2].high, c[3].high};
}

Step Begin(const Plane& plane) noexcept {
  if (!IsFinite(plane))
    return Status::Failure(Error::kNotFinite, "the plane has a coefficient that is not finite");
  return Bounded{{{plane.x, 0}, {plane.y, 0}, {plane.z, 0}, {plane.w, 0}}, {}};
}

Step Through(const Step& before, const Matrix& matrix, const char* name) noexcept {
  if (!before.ok()) return before;
  // A matrix whose inverse holds needs no further check.
  const AffineInverse inverse = InverseOfAffine(matrix);
  Step after;
  if (inverse.holds && TakeThrough(inverse, before.value, after.value)) return after;
  if (Status status = CheckAffine(matrix, name); !status.ok()) return status;
  return Eliminated(before.value, matrix, name);
}

Step ThroughCamera(const Step& before, const PreparedCamera& camera) noexcept {
  if (!before.ok()) return before;
  Step in_view;
  if (!camera.view_inverse.holds ||
      !TakeThrough(camera.view_inverse, before.value, in_view.value)) {
    in_view = Eliminated(before.value, camera.view, "view");
    if (!in_view.ok()) return in_view;
  }
  return Projected(in_view.value, camera.projection, camera.shape);
}

Step Before(const Step& after, const Matrix& matrix, const char* name) noexcept {
  if (!after.ok()) return after;
  if (const Status status = CheckAffine(matrix, name); !status.ok()) return status;
  Bounded before;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double element = matrix.m[i][j];
      if (element != 0 && after.value.plane[j].high != 0) before.error[i] += kUnderflow;
      before.plane[i] = Add(before.plane[i], Multiply(element, after.value.plane[j]));
      before.error[i] += std::fabs(element) * after.value.error[j] +
                         kRoundingOfProducts * std::fabs(element * after.value.plane[j].high);
    }
  }
  return before;
}

Bounded ThroughShape(const Bounded& before, const ProjectionShape& s) noexcept {
  double c[4], ce[4], p[4], e[4];
  Round(before, c, ce);
  p[0] = c[0] / s.px;
  p[1] = c[1] / s.py;
  e[0] = RoundingOf(p[0], c[0]) + ce[0] / std::fabs(s.px);
  e[1] = RoundingOf(p[1], c[1]) + ce[1] / std::fabs(s.py);
  // Row 2: ox x + oy y + a z + e w = c.z. Row 3: tx x + ty y + b z + g w = c.w.
  const auto rest = [&](double c_i, double o_x, double o_y) {
    return c_i - o_x * p[0] - o_y * p[1];
  };
  // The two differences round c_i and the first product.
  const auto rest_error = [&](double c_i, double c_error, double o_x, double o_y) {
    return 2 * std::fabs(c_i) + c_error + std::fabs(o_x) * (3 * std::fabs(p[0]) + e[0]) +
           std::fabs(o_y) * (2 * std::fabs(p[1]) + e[1]);
  };
  const double rest2 = rest(c[2], s.ox, s.oy), error2 = rest_error(c[2], ce[2], s.ox, s.oy);
  const double rest3 = rest(c[3], s.tx, s.ty), error3 = rest_error(c[3], ce[3], s.tx, s.ty);
  if (s.is_perspective()) {
    p[2] = rest3 / s.b;
    e[2] = RoundingOf(p[2], rest3) + error3 / std::fabs(s.b);
    p[3] = (rest2 - s.a * p[2]) / s.e;
    e[3] =
        2 * std::fabs(p[3]) + (error2 + std::fabs(s.a) * (std::fabs(p[2]) + e[2])) / std::fabs(s.e);
  } else {
    p[2] = rest2 / s.a;
    e[2] = RoundingOf(p[2], rest2) + error2 / std::fabs(s.a);
    p[3] = (rest3 - s.b * p[2]) / s.g;
    e[3] =
        2 * std::fabs(p[3]) + (error3 + std::fabs(s.b) * (std::fabs(p[2]) + e[2])) / std::fabs(s.g);
  }
  Bounded after;
  for (int i = 0; i < 4; ++i) after.plane[i].high = p[i], after.error[i] = e[i];
  return after;
}

Step ThroughProjection(const Step& before, const Matrix& projection) noexcept {
  if (!before.ok()) return before;
  if (const Status status = CheckProjection(projection); !status.ok()) return status;
  return Projected(before.value, projection, ShapeOf(projection));
}

Step ToXyw1(const Step& view_plane, const Matrix& projection) noexcept {
  if (!view_plane.ok()) return view_plane;
  if (const Status status = CheckProjection(projection); !status.ok()) return status;
  const ProjectionShape s = ShapeOf(projection);
  if (!s.is_perspective() || s.tx != 0 || s.ty != 0) {
    return Status::Failure(
        Error::kWrongProjection,
        "plane space xyw1 needs a perspective; for others plane space clip is as accurate");
  }
  double c[4], ce[4];
  Round(view_plane.value, c, ce);
  const double x = c[0] / s.px, y = c[1] / s.py;
  const double k[4] = {x, y, (c[2] - s.ox * x - s.oy * y) / s.e, c[3]};
  Bounded constant;
  for (int i = 0; i < 4; ++i) constant.plane[i].high = k[i];
  const double x_error = ce[0] / std::fabs(s.px), y_error = ce[1] / std::fabs(s.py);
  constant.error[0] = RoundingOf(x, c[0]) + x_error;
  constant.error[1] = RoundingOf(y, c[1]) + y_error;
  constant.error[2] = std::fabs(k[2]) + (2 * std::fabs(c[2]) + ce[2] +
                                         std::fabs(s.ox) * (4 * std::fabs(x) + x_error) +
                                         std::fabs(s.oy) * (3 * std::fabs(y) + y_error)) /
                                            std::fabs(s.e);
  constant.error[3] = ce[3];
  return constant;
}

Result<PlaneConstant> Finish(const Step& step) noexcept {
  if (!step.ok()) return step.status;
  double c[4], error[4];
  Round(step.value, c, error);
  const double largest = LargestOf(c);
  const double most_error = LargestOf(error);
  const double condition = most_error == 0 ? 0 : most_error / largest;
  // The largest component, where it is not finite, says so below.
  if (std::isfinite(largest) && !(condition <= kMaxCondition)) {
    return Status::Failure(Error::kIllConditioned,
                           "the plane is not right to float precision: its condition is %.2g",
                           condition);
  }
  const Plane plane = Rounded(step.value);
  const Result<Float4> rounded = RoundPlane(plane);
  if (!rounded.ok()) return rounded.status;
  return PlaneConstant{rounded.value, plane, condition};
}

}  // namespace clipc::runtime
