// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/projection_shape.h"

#include <cmath>

#include "runtime/finite.h"

namespace clipc::runtime {

ProjectionShape ShapeOf(const Matrix& projection) noexcept {
  const auto& m = projection.m;
  ProjectionShape shape;
  shape.px = m[0][0], shape.py = m[1][1];
  shape.ox = m[2][0], shape.oy = m[2][1], shape.a = m[2][2], shape.e = m[2][3];
  shape.tx = m[3][0], shape.ty = m[3][1], shape.b = m[3][2], shape.g = m[3][3];
  const bool others_are_zero =
      m[0][1] == 0 && m[0][2] == 0 && m[0][3] == 0 && m[1][0] == 0 && m[1][2] == 0 && m[1][3] == 0;
  shape.holds = IsFinite(projection) && others_are_zero && shape.px != 0 && shape.py != 0 &&
                (shape.e == 0) != (shape.g == 0);
  return shape;
}

bool LooksTransposed(const Matrix& affine) noexcept {
  const auto& m = affine.m;
  return m[3][0] == 0 && m[3][1] == 0 && m[3][2] == 0 && m[3][3] == 1 &&
         (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0);
}

Status CheckProjection(const Matrix& projection) noexcept {
  const auto& m = projection.m;
  if (!IsFinite(projection)) {
    return Status::Failure(Error::kNotFinite,
                           "the projection matrix has an element that is not finite");
  }
  const bool ends_in_w = m[3][0] == 0 && m[3][1] == 0 && std::fabs(m[3][2]) == 1 && m[3][3] == 0;
  if (LooksTransposed(projection) || (ends_in_w && std::fabs(m[2][3]) != 1)) {
    return Status::Failure(Error::kLooksTransposed,
                           "the projection matrix looks transposed: its last row is what the last "
                           "column of one for row vectors is; see ColumnVectorMatrix");
  }
  return {};
}

double NearW(const ProjectionShape& shape, DepthRange range) noexcept {
  // z = a s + b and w = e s meet the near plane z = near * w where (a - near * e) s = -b.
  const double near = range.reversed ? 1 : range.negative_one_to_one ? -1 : 0;
  return -shape.e * shape.b / (shape.a - near * shape.e);
}

}  // namespace clipc::runtime
