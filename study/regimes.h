// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "study/setup.h"
#include "study/way.h"

namespace clipc::study {

// The regimes in which users draw, one after the other; each with a plane, a camera and an object
// that nobody chose.
enum class Regime {
  kOrdinary,             // any perspective, the object around its own origin
  kMeshOffset,           // vertices far from the mesh's own origin
  kMatricesInTheShader,  // far from the world's origin, two or three matrices in the shader
  kFloatProduct,         // far from the world's origin, one matrix multiplied in float
  kWorldSpace,           // distances by hand from a world-space vertex
  kOrthographic,         // up to thousands of half heights away, standard or reversed depth
  kMinusOneToOne,        // clip space from -1 to 1, standard or reversed depth
  kOffCentre,            // tiles of a large picture, up to three pictures off the axis
  kGround,               // one plane from near to far
  kMirrored,             // the view of a reflection
  kUnevenScale,          // a world matrix that stretches
};
inline constexpr int kRegimes = static_cast<int>(Regime::kUnevenScale) + 1;
const char* NameOf(Regime regime);

// A draw of a regime, and the way that clips it.
struct RegimeDraw {
  Regime regime;
  Config config;
  WayKind way;
  double sine;  // of the angle between surface and plane
  runtime::MatrixOrder order = runtime::MatrixOrder::kOneMatrix;
};

// Random draws of all regimes in turn. Equal seeds give equal draws.
std::vector<RegimeDraw> RegimeDraws(int count, std::uint64_t seed);

// The law (study/law.h) of a draw.
double LawOf(const RegimeDraw& draw);

// The agreement of a law with the draws of a regime.
struct RegimeHeld {
  Regime regime;
  int draws = 0;  // draws with a prediction of at most 20 pixels, beyond which an edge is too short
  int low = 0, high = 0;  // draws with a 99th percentile below 0.2, above 3 predictions
  double least = 0, median = 0, most = 0;  // draws' 99th percentiles over their predictions
  double pooled = 0;  // 99th percentile of all edges' displacements over their draws' predictions
};

// Measures `count` draws, with some planes of each (DisplacementsOverPlanes) and `edges` edges of
// each plane, and holds them against `law`; five times as many planes of a draw that seems to be
// outside its factor. Equal arguments give equal results.
std::vector<RegimeHeld> HoldLaw(int count, long edges, std::uint64_t seed,
                                const std::function<double(const RegimeDraw&)>& law);

// The errors of `count` draws of one plane each whose matrices are multiplied in that order, far
// from the world's origin, over their predictions; in order of size. Draws are left out as above.
std::vector<double> SingleDraws(runtime::MatrixOrder order, int count, long edges,
                                std::uint64_t seed);

}  // namespace clipc::study
