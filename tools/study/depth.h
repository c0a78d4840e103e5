// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "runtime/matrix.h"
#include "tools/study/camera.h"

namespace clipc::study {

// What a depth buffer still tells apart when the near plane was sheared into the clip plane.
struct DepthLeft {
  std::string method;    // "standard", "reversed", "near-plane", "near-plane-unit"
  bool refused = false;  // clipc::runtime refuses the method here; measured all the same
  double effective_near = 0;
  double ordered = 0, tied = 0,
         inverted = 0;  // shares of point pairs on one ray, 0.1 % of their distance apart
  double lost = 0;      // share of visible points that the far plane takes away
};

// `plane` in the camera's space; its w is the eye's signed distance. Fixed point depth of 24 bits,
// but `reversed` a float.
std::vector<DepthLeft> MeasureDepth(const Camera& camera, const runtime::Plane& plane, long pairs,
                                    std::uint64_t seed);

}  // namespace clipc::study
