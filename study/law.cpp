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

// The rounding of the cut's vertices, where they are farthest from their origin: u H (1/2 + R +
// length), with lengths in heights of the image at the vertex.
double OfVertices(const Setup& setup, const std::vector<Vector>& cut, double image_height) {
  const Camera& camera = setup.config.camera;
  const Vector origin = OriginInView(setup.world_view);
  double farthest = 0;
  for (const Vector& place : cut) {
    const Vector away = place - origin;
    farthest = std::max(farthest, std::sqrt(Dot(away, away)) / (2 * camera.HalfHeightAt(place.z)));
  }
  return 0x1p-24 * image_height * (0.5 + farthest + setup.EdgeInHalfImages() / 2);
}

}  // namespace

double LawOf(const Setup& setup, const Way& way, runtime::MatrixOrder order, double image_height,
             double sine) {
  const std::vector<Vector> cut = RandomCuts(setup, kPlaces);
  if (cut.empty()) return 0;
  if (way.kind == WayKind::kCpu) return OfVertices(setup, cut, image_height);
  std::vector<double> places;
  for (const Vector& seen : cut) {
    const Vec4<double> place =
        Transform(Vec4<double>{{seen.x, seen.y, seen.z, 1}}, setup.to_object);
    places.insert(places.end(), place.c, place.c + 3);
  }
  const runtime::SeenCut seen = {places.data(), cut.size(), setup.EdgeInHalfImages()};
  if (!way.space) {
    // Distances by hand round the world-space vertex, and its dot product with the plane.
    runtime::DistanceArithmetic by_hand;
    by_hand.count = 1, by_hand.matrices[0] = setup.world;
    by_hand.constant = setup.world_plane;
    return EdgeErrorOf(by_hand, setup.config.view_plane, setup.world_view, setup.projection, seen,
                       image_height, sine);
  }
  const runtime::DrawMatrices matrices = {setup.world, setup.view, setup.projection, order};
  const auto law = PredictEdgeError(*way.space, setup.world_plane, runtime::KnownIn::kWorld,
                                    matrices, seen, image_height, sine);
  return law.ok() ? law.value : INFINITY;
}

}  // namespace clipc::study
