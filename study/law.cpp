// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/law.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/edge_error.h"

namespace clipc::study {
namespace {

// The number of places of a cut: as many as have edges of every direction each.
constexpr std::size_t kPlaces = 64;

// The way of a vertex to its position in a draw.
runtime::SeenDraw DrawOf(const Setup& setup, const runtime::DrawMatrices& matrices) {
  return {setup.config.view_plane, setup.world_view, setup.projection,
          runtime::PositionArithmetic(matrices)};
}

}  // namespace

runtime::EdgeDisplacement LawOf(const Setup& setup, const Way& way, runtime::MatrixOrder order,
                                double image_height, double sine) {
  const std::vector<Vector> cut = RandomCuts(setup, kPlaces);
  if (cut.empty()) return {};
  std::vector<double> places;
  for (const Vector& seen : cut) {
    const Vec4<double> place =
        Transform(Vec4<double>{{seen.x, seen.y, seen.z, 1}}, setup.to_object);
    places.insert(places.end(), place.c, place.c + 3);
  }
  const runtime::SeenCut seen = {places.data(), cut.size(), setup.EdgeInHalfImages()};
  const runtime::DrawMatrices matrices = {setup.world, setup.view, setup.projection, order};
  if (way.kind == WayKind::kCpu)
    return ClippedVertexErrorOf(DrawOf(setup, matrices), seen, image_height);
  if (!way.space) {
    // Distances by hand round the world-space vertex, and its dot product with the plane.
    runtime::DistanceArithmetic by_hand;
    by_hand.count = 1, by_hand.matrices[0] = setup.world;
    by_hand.constant = setup.world_plane;
    return EdgeErrorOf(by_hand, DrawOf(setup, matrices), seen, image_height, sine);
  }
  const auto law = PredictEdgeDisplacement(*way.space, setup.world_plane, runtime::KnownIn::kWorld,
                                           matrices, seen, image_height, sine);
  if (!law.ok()) return {INFINITY, INFINITY, INFINITY};
  return law.value;
}

}  // namespace clipc::study
