// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/matrix.h"
#include "runtime/plane_space.h"
#include "study/numbers.h"

namespace clipc::study {

struct Way;

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

// One plane of a draw, and how far its cut is from the object's own origin and from the world's:
// the reach of PredictEdgeError.
struct CutFacts {
  Plane view_plane;  // in the camera's space
  double reach = runtime::kAroundOrigin, world_reach = runtime::kAroundOrigin;
};

// One draw to give advice on.
struct DrawFacts {
  Camera camera;
  int planes = 1;
  // Each plane that cuts the object in the picture. No single one stands for the others: the
  // nearest cut is worst for some ways, the plane farthest from the eye for others.
  std::vector<CutFacts> cuts = std::vector<CutFacts>(1);
  double picture_height = 1080;  // pixels
  // The sine of the angle between surface and plane; 0.1 stands for surfaces of every direction.
  double sine = 0.1;
  // The longest edge of a triangle, or the object's size, in half pictures.
  double extent = 0;
  Means means;
};

// The factor by which edges of this length worsen every predicted error, except that of clipping on
// the CPU in double.
inline double LengthFactor(double extent) { return 1 + extent / 8; }

// The measured cost of a way (study/way.h) with a number of planes, relative to
// drawing without planes.
using CostTable = std::map<std::pair<std::string, int>, double>;

struct Advice {
  std::string way;
  bool possible = false;  // by the means, the projection and the place of the eye
  double predicted = 0;   // pixels: the law for the 99th percentile of displaced edges
  // Pixels: the 99th percentile of edges as long as a twentieth of the depth stays under it, but
  // for a few draws in a hundred; kBoundFactor times the law.
  double bound = 0;
  bool meets = false;  // possible, with a cost, and the bound is within the tolerance
  double cost = 0;     // from the table; infinity where the table does not have the way
};

// The factor from a law to its bound, as a single plane or matrix may round unluckily, and as the
// law does not know where in the picture the cut is.
inline constexpr double kBoundFactor = 4;
// Costs closer than this share to the least count as equal: the more accurate way wins. Two tables
// of one run differ by nearly as much for one way.
inline constexpr double kSameCost = 0.15;
// The step of rasterisers, in pixels: what is below changes a pixel at most, as a rule. Predictions
// under it count as equal, and the way that comes first in kWays wins.
inline constexpr double kInvisible = 1.0 / 256;

// A function that measures the error of a way in the draw: pixels, the 99th percentile; none where
// it cannot.
using Measure = std::function<std::optional<double>(const Way&)>;

// The multiple of a measured error that other edges stay under: the error is of these planes and
// matrices alone, and of some of the edges.
inline constexpr double kMeasuredFactor = 1.5;

// All ways but `none` and `near-plane-f32`, the recommended one first: the cheapest of those that
// meet `tolerance`, and the most accurate of equally cheap ones. Where none meets it, the most
// accurate way that is possible comes first. Impossible ways come last. Where the law leaves open
// whether a way meets the tolerance, `measure` decides, if it is given: then `predicted` is what it
// measured.
std::vector<Advice> Advise(const DrawFacts& facts, const CostTable& costs, double tolerance = 0.5,
                           const Measure& measure = {});

// The change to the application by which a way meets a tolerance that none meets; empty where none
// is known.
std::string CureFor(const DrawFacts& facts, const CostTable& costs, double tolerance);

}  // namespace clipc::study
