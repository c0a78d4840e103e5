// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/mirror.h"

#include <cmath>

namespace clipc::runtime {

Result<Matrix> MirrorMatrix(const Plane& plane) noexcept {
  const double length = NormalLength(plane);
  if (!std::isfinite(length) || !std::isfinite(plane.w)) {
    return Status::Failure(Error::kNotFinite,
                           "the mirror's plane has a coefficient that is not finite");
  }
  if (length == 0) return Status::Failure(Error::kSingular, "the mirror's plane has no normal");
  Matrix mirror;
  const double normal[3] = {plane.x / length, plane.y / length, plane.z / length};
  const double coefficients[4] = {normal[0], normal[1], normal[2], plane.w / length};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column)
      mirror.m[row][column] -= 2 * coefficients[row] * normal[column];
  }
  return mirror;
}

}  // namespace clipc::runtime
