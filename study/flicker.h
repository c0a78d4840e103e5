// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/method.h"
#include "study/setup.h"

namespace clipc::study {

// The movement of the cut over a still surface while the camera pans, in pixels from one frame to
// the next. The exact cut is still; only its rounding moves.
struct Flicker {
  std::string method;
  bool applies = false;                     // the method can be used in every frame
  double median = 0, p99 = 0, largest = 0;  // pixels a frame, along the surface as it is drawn
  double p99_in_image = 0;                  // with the trembling of the surface's own vertices
};

// Pans by `step` radians a frame over `frames` frames, with `count` edges that the plane cuts in
// the first. Matrices and constants are made anew for each frame, as an application does. Equal
// arguments give equal results. The view has no mirror.
std::vector<Flicker> MeasureFlicker(const Config& config, const std::vector<Method>& methods,
                                    int frames, double step, long count, std::uint64_t seed);

}  // namespace clipc::study
