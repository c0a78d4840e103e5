// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "tools/draw/gl.h"

namespace clipc::study {

// What odd planes and odd triangles do on a real clipper, for each way that can be given them.
struct SpecialResult {
  std::string sweep;  // "special values", "triangles through w = 0", "multisampling"
  std::string what;
  std::string way;
  // Special values: the share of the fragments without a plane that are drawn. Through w = 0: those
  // drawn with the plane and those with its opposite, together. Multisampling: the share of the
  // picture's rows where the cut is smooth.
  double got = 0, right = 0;
};

std::vector<SpecialResult> MeasureSpecial(draw::Device& device);

}  // namespace clipc::study
