// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "runtime/matrix.h"
#include "tools/study/camera.h"

namespace clipc::study {

// What the machine and the object allow.
struct Means {
  bool clip_distances = true;  // gl_ClipDistance: OpenGL 3, Vulkan, ES 3 with an extension
  bool user_planes = false;    // Direct3D 9's SetClipPlane, OpenGL 2's glClipPlane
  bool can_discard = true;     // the fragment shader is ours to change
  bool rigid =
      true;  // the position is the vertex times matrices: no skinning, no instances, no waves
};

// One draw to advise on.
struct DrawFacts {
  Camera camera;
  runtime::Plane view_plane;  // the plane that matters, in the camera's space
  int planes = 1;
  double depth = 10;             // view-space depth of the cut
  double world_offset = 0;       // distance of the object from the world's origin
  double picture_height = 1080;  // pixels
  double sine =
      0.1;  // of the angle between surface and plane; 0.1 stands for surfaces of every direction
  double extent =
      0;  // longest edge of a triangle, or the object's size, in half pictures at `depth`
  Means means;
};

// What edges that long multiply every law with, but that of vertices cut in double.
inline double LengthFactor(double extent) { return 1 + extent / 8; }

// Cost of a way (tools/study/program/way.h) with so many planes, relative to drawing without:
// measured, not assumed.
using CostTable = std::map<std::pair<std::string, int>, double>;

struct Advice {
  std::string way;
  bool possible = false;  // by the means, the projection and where the eye stands
  double predicted = 0;   // pixels: the law for the 99th percentile of displaced edges
  double bound = 0;  // pixels: what the 99th percentile stays under, kBoundFactor times the law
  double cost = 0;   // of the table; infinity where it has no such way
};

// A single plane or matrix may round unluckily: of all that is possible in 120 random
// draws (seed 2024) the worst was 3.0 times its law. The tests take other draws.
inline constexpr double kBoundFactor = 4;
// Costs closer than this count as equal: the more accurate way wins.
inline constexpr double kSameCost = 0.03;

// All ways, the recommended one first: of the possible ones whose bound is within `tolerance`
// pixels the cheapest, and of equally cheap ones the most accurate; where none is, the most
// accurate. Impossible ways come last.
std::vector<Advice> Advise(const DrawFacts& facts, const CostTable& costs, double tolerance = 0.5);

}  // namespace clipc::study
