// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "runtime/plane_space.h"
#include "study/setup.h"

namespace clipc::study {

// The means that the machine and the object offer.
struct Means {
  bool clip_distances = true;  // gl_ClipDistance: OpenGL 3, Vulkan, ES 3 with an extension
  bool user_planes = false;    // Direct3D 9's SetClipPlane, OpenGL 2's glClipPlane
  bool can_discard = true;     // the fragment shader is ours to change
  bool rigid = true;  // the position is the vertex times matrices: no skinning, instances or waves
  runtime::MatrixOrder order = runtime::MatrixOrder::kOneMatrix;
  // Every object that the pass draws is cut by the same one plane, so that `near-plane` may replace
  // the depth of them all. Next to ordinary depth it hides and shows what it should not.
  bool whole_pass = false;
};

// One draw to give advice on.
struct DrawFacts {
  Camera camera;
  int planes = 1;
  // The draw by each plane whose cut the image shows. No single one stands for the others: the
  // nearest cut is worst for some ways, the plane farthest from the eye for others.
  std::vector<Setup> cuts;
  double image_height = kImageHeight;  // pixels
  // What is compared with the tolerance.
  runtime::JudgedIn judged_in = runtime::JudgedIn::kImage;
  Means means;
};

// The measured cost of a way (study/way.h) with a number of planes, relative to
// drawing without planes.
using CostTable = std::map<std::pair<std::string, int>, double>;

struct Advice {
  std::string way;
  bool possible = false;  // by the means, the projection and the place of the eye
  // Pixels: the law (study/law.h) of the plane where it is largest, along the object's surface and
  // in the image, and the one of the two by which the draw is judged.
  double along_surface = 0, in_image = 0, predicted = 0;
  // Pixels: the 99th percentile of edges as long as a twentieth of the depth stays under it;
  // kBound times the law.
  double bound = 0;
  bool meets = false;  // possible, and the bound is within the tolerance
  double cost = 0;     // from the table; infinity where the table does not have the way

  bool has_cost() const { return cost < INFINITY; }
};

// The factor by which a law is off at most (study/regimes.h holds it against measurements).
inline constexpr double kBound = 3;
// Costs closer than this share to the least count as equal: the more accurate way wins. Two tables
// of one run differ by nearly as much for one way.
inline constexpr double kSameCost = 0.15;
// The step of rasterisers, in pixels: what is below changes a pixel at most, as a rule. Predictions
// under it count as equal, and the way that comes first in kWays wins.
inline constexpr double kInvisible = 1.0 / 256;

// All ways but `none` and `near-plane-f32`, the recommended one first: the cheapest of those that
// meet `tolerance`, and the most accurate of equally cheap ones; then the ways that meet it without
// a cost, the most accurate first. Where none meets it, the most accurate way that is possible
// comes first. Impossible ways come last, without a prediction.
std::vector<Advice> Advise(const DrawFacts& facts, const CostTable& costs, double tolerance = 0.5);

// The change to the application by which a way meets a tolerance that none meets; empty where none
// is known.
std::string CureFor(const DrawFacts& facts, const CostTable& costs, double tolerance);

}  // namespace clipc::study
