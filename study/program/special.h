// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

namespace clipc::study {

// The image of an odd plane or odd triangles on a real clipper, for one way to clip.
struct SpecialResult {
  std::string sweep;  // "special values", "triangles through w = 0", "multisampling"
  std::string what;
  std::string way;
  // Special values: the drawn share of the fragments that there are without a plane. Triangles
  // through w = 0: the same share, with the plane and with its opposite together. Multisampling:
  // the share of the image's rows where the cut is smooth.
  double got = 0, right = 0;
};

// Measures each way that can be given such planes and triangles. An OpenGL context of the
// compatibility profile must be current.
std::vector<SpecialResult> MeasureSpecial();

}  // namespace clipc::study
