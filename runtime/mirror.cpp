// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/mirror.h"

#include <algorithm>
#include <cmath>

#include "runtime/finite.h"

namespace clipc::runtime {

Result<Matrix> MirrorMatrix(const Plane& plane) noexcept {
  if (!IsFinite(plane)) {
    return Status::Failure(Error::kNotFinite,
                           "the mirror's plane has a coefficient that is not finite");
  }
  const double largest = std::max({std::fabs(plane.x), std::fabs(plane.y), std::fabs(plane.z)});
  if (largest == 0) return Status::Failure(Error::kSingular, "the mirror's plane has no normal");
  // The normal is scaled by a power of two, so that its length neither overflows nor underflows.
  const int exponent = std::ilogb(largest);
  const Plane scaled = {std::scalbn(plane.x, -exponent), std::scalbn(plane.y, -exponent),
                        std::scalbn(plane.z, -exponent), plane.w};
  const double length = NormalLength(scaled);
  Matrix mirror;
  const double normal[3] = {scaled.x / length, scaled.y / length, scaled.z / length};
  const double coefficients[4] = {normal[0], normal[1], normal[2],
                                  std::scalbn(plane.w / length, -exponent)};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column) {
      mirror.m[row][column] -= 2 * coefficients[row] * normal[column];
      if (!std::isfinite(mirror.m[row][column]))
        return Status::Failure(Error::kNotRepresentable,
                               "the mirror is too far from the origin for a double");
    }
  }
  return mirror;
}

}  // namespace clipc::runtime
