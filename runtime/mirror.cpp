// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/mirror.h"

#include <cmath>

namespace clipc::runtime {

Result<Matrix> MirrorMatrix(const Plane& plane) noexcept {
  Result<Matrix> result;
  const double length = NormalLength(plane);
  if (!std::isfinite(length) || !std::isfinite(plane.w)) {
    result.status = Status::Failure(Error::kNotFinite,
                                    "the mirror's plane has a coefficient that is not finite");
    return result;
  }
  if (length == 0) {
    result.status = Status::Failure(Error::kSingular, "the mirror's plane has no normal");
    return result;
  }
  const double normal[3] = {plane.x / length, plane.y / length, plane.z / length};
  const double coefficients[4] = {normal[0], normal[1], normal[2], plane.w / length};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column)
      result.value.m[row][column] -= 2 * coefficients[row] * normal[column];
  }
  return result;
}

}  // namespace clipc::runtime
