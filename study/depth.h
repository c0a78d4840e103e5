// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "runtime/matrix.h"
#include "study/numbers.h"

namespace clipc::study {

// The order of points in a depth buffer after the near plane was sheared into the clip plane.
struct DepthLeft {
  std::string method;    // "standard", "reversed", "near-plane", "near-plane-unit"
  bool refused = false;  // clipc::runtime refuses the method here; it is measured all the same
  double effective_near = 0;
  // Shares of the pairs of points on one ray that are 0.1 % of their distance apart.
  double ordered = 0, tied = 0, inverted = 0;
  double lost = 0;  // share of the visible points that the far plane takes away
};

// Measures each method with random pairs of points. `plane` is in the camera's space; its w is the
// eye's signed distance. Depth has 24 bits in fixed point; that of "reversed" is a float.
std::vector<DepthLeft> MeasureDepth(const Camera& camera, const Plane& plane, long pairs,
                                    std::uint64_t seed);

}  // namespace clipc::study
