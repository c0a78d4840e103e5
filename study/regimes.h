// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "study/setup.h"
#include "study/way.h"

namespace clipc::study {

// The regimes in which users draw; each draw has a plane, a camera and an object that nobody chose.
enum class Regime {
  kOneMatrix,  // any perspective, the object around its own origin
  // Far from the world's origin, by the order in which float multiplies matrices.
  kWorldFirst,
  kWorldViewFirst,
  kThreeMatrices,
  kFloatWorldView,
  kFloatViewProjection,
  kMeshOffset,     // vertices far from the mesh's own origin
  kWorldSpace,     // distances by hand from a world-space vertex
  kOrthographic,   // up to thousands of half heights away, standard or reversed depth
  kMinusOneToOne,  // clip space from -1 to 1, standard or reversed depth
  kOffCentre,      // tiles of a large image, up to three images off the axis
  kGround,         // one plane from near to far
  kMirrored,       // the view of a reflection
  kUnevenScale,    // a world matrix that stretches
  kProcessor,      // the application clips, in views of up to 160 degrees
};
inline constexpr int kRegimes = static_cast<int>(Regime::kProcessor) + 1;
const char* NameOf(Regime regime);

// A draw of a regime, and the way that clips it.
struct RegimeDraw {
  Regime regime;
  Config config;
  WayKind way;
  double sine;  // of the angle between surface and plane
  runtime::MatrixOrder order = runtime::MatrixOrder::kOneMatrix;
};

// Random draws of a regime. Equal seeds give equal draws.
class DrawsOf {
 public:
  DrawsOf(Regime regime, std::uint64_t seed);
  RegimeDraw Next();

 private:
  Regime regime_;
  Random random_;
};

// The law (study/law.h) of a draw.
runtime::EdgeDisplacement LawOf(const RegimeDraw& draw);

// The agreement of a law with displacements.
struct Held {
  int low = 0, high = 0;  // draws with a 99th percentile below 0.2, above 3 predictions
  double least = 0, median = 0, most = 0;  // draws' 99th percentiles over their predictions
  double pooled = 0;  // 99th percentile of all edges' displacements over their draws' predictions
};

// The agreement of a law with the draws of a regime.
struct RegimeHeld {
  Regime regime;
  int draws = 0;
  Held along_surface, in_image;
};

// Measures `count` draws of a regime, `edges` edges in each view (study/edges.h), and holds their
// 99th percentiles against `law`. Left out are draws of which the views show less than half of the
// edges, or that lose more than 20 pixels, by which an edge is too short; fewer draws are held
// where that leaves out half of all. Equal arguments give equal results.
RegimeHeld HoldLaw(Regime regime, int count, long edges, std::uint64_t seed,
                   const std::function<runtime::EdgeDisplacement(const RegimeDraw&)>& law);

}  // namespace clipc::study
