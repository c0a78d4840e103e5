// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "tools/study/setup.h"

namespace clipc::study {

// One setting of one parameter, everything else ordinary.
struct SweepPoint {
  std::string sweep;  // "near-far", "field-of-view"
  double parameter;   // what it is set to, in the unit that UnitOf names
  Config config;
};

// Every failure boundary that the methods have. `quick`: fewer points of each.
std::vector<SweepPoint> AllSweeps(bool quick);

// An oblique plane that crosses the view axis at `depth`, surfaces from half to twice that depth.
Config ObliqueAt(double depth, double near = 0.1, double far = 1000);

}  // namespace clipc::study
