// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "study/setup.h"

namespace clipc::study {

// One value of one parameter, while all others have ordinary values.
struct SweepPoint {
  std::string sweep;  // "near-far", "field-of-view"
  double parameter;   // the value
  Config config;
};

// Sweeps over the boundaries of which the documents speak. If `quick`, they have fewer points.
std::vector<SweepPoint> AllSweeps(bool quick);

// A case with an oblique plane that crosses the view axis at `depth`, and surfaces from half to
// twice that depth.
Config ObliqueAt(double depth, double near = 0.1, double far = 1000);

}  // namespace clipc::study
