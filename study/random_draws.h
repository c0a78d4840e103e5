// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "study/advice.h"
#include "study/setup.h"

namespace clipc::study {

// A random draw: any projection, plane, offset and machine that the advice is for.
struct RandomDraw {
  Config config;
  DrawFacts facts;
};

// Random draws. Equal seeds give equal draws. They have fields of view of 10 to 120 degrees, near
// planes of 1e-3 to 1, surfaces that meet the plane at 5 degrees or more.
std::vector<RandomDraw> RandomDraws(int count, std::uint64_t seed);

// The errors of a way's arithmetic, measured by MeasureEdges. `applies` is false where the way
// cannot be used.
struct MeasuredWay {
  bool applies = false;
  double p99 = 0;
};
MeasuredWay MeasureWay(const RandomDraw& draw, const std::string& way, long edges,
                       std::uint64_t seed);

}  // namespace clipc::study
