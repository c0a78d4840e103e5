// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/edge_maker.h"

#include <cmath>

namespace clipc::study {
namespace {

Vec4<long double> ClipOf(const Setup& setup, const Vec4<float>& vertex) {
  using Long = long double;
  const Vec4<Long> in_view =
      Transform(Transform(ConvertTo<Long>(vertex), ConvertTo<Long>(setup.world)),
                ConvertTo<Long>(setup.view));
  return Transform(in_view, ConvertTo<Long>(setup.projection));
}

long double HalfWidth(const Setup& setup) { return kImageHeight / 2 * setup.config.camera.aspect; }

Point PixelOf(const Vec4<long double>& p, long double half_width) {
  return {p[0] / p[3] * half_width, p[1] / p[3] * (kImageHeight / 2)};
}

}  // namespace

double Between(const Point& a, const Point& b) {
  return static_cast<double>(std::hypot(a.x - b.x, a.y - b.y));
}

SeenEdge::SeenEdge(const Setup& setup, const Edge& edge)
    : clip_{ClipOf(setup, edge.ends[0]), ClipOf(setup, edge.ends[1])},
      half_width_(HalfWidth(setup)) {}

SeenEdge::SeenEdge(const Setup& setup, const Vec4<float>& first, const Vec4<float>& second)
    : clip_{ConvertTo<long double>(first), ConvertTo<long double>(second)},
      half_width_(HalfWidth(setup)) {}

Point SeenEdge::At(long double share) const {
  Vec4<long double> p;
  for (int i = 0; i < 4; ++i) p[i] = clip_[0][i] + share * (clip_[1][i] - clip_[0][i]);
  return PixelOf(p, half_width_);
}

Point PointOf(const Setup& setup, const Vec4<float>& vertex) {
  return PixelOf(ClipOf(setup, vertex), HalfWidth(setup));
}

Point PointOfPosition(const Setup& setup, const Vec4<float>& position) {
  return PixelOf(ConvertTo<long double>(position), HalfWidth(setup));
}

long double CutShare(const Edge& edge, const double (&distances)[2]) {
  const bool kept[2] = {distances[0] >= 0, distances[1] >= 0};
  if (kept[0] == kept[1]) {
    const bool first_is_kept = edge.distances[0] >= 0;
    return first_is_kept == kept[0] ? 1 : 0;
  }
  const long double first = distances[0], second = distances[1];
  return first / (first - second);
}

long double TrueShare(const Edge& edge) {
  return static_cast<long double>(edge.distances[0] / (edge.distances[0] - edge.distances[1]));
}

EdgeMaker::EdgeMaker(const Setup& setup, std::uint64_t seed)
    : setup_(setup),
      config_(setup.config),
      normal_(NormalOf(config_.view_plane)),
      random_(seed),
      world_(ConvertTo<Wide>(setup.world)),
      plane_(ConvertTo<Wide>(setup.world_plane)) {}

std::optional<Edge> EdgeMaker::Next() {
  const std::optional<Vector> point = RandomCut(setup_, random_);
  if (!point) return std::nullopt;
  const Vector direction = ChooseDirection();
  const double size = config_.camera.orthographic ? config_.camera.half_height : point->z;
  const double length = config_.edge_length * size, before = random_.Between(0.2, 0.8);
  Edge edge;

  for (int end = 0; end < 2; ++end) {
    const Vector place = *point + (end == 0 ? -before : 1 - before) * length * direction;
    edge.ends[end] =
        ConvertTo<float>(Transform(Vec4<double>{{place.x, place.y, place.z, 1}}, setup_.to_object));
    edge.ends[end][3] = 1;
    edge.distances[end] = Dot(Transform(ConvertTo<Wide>(edge.ends[end]), world_), plane_);
  }
  if ((edge.distances[0] >= 0) == (edge.distances[1] >= 0)) return std::nullopt;
  return edge;
}

Vector EdgeMaker::ChooseDirection() {
  Vector direction;
  do direction = random_.Direction();
  while (std::fabs(Dot(direction, normal_)) <= config_.least_sine);
  if (config_.surface_angle < 0) return direction;
  Vector along;  // the direction's part in the plane
  do {
    direction = random_.Direction();
    along = direction - Dot(direction, normal_) * normal_;
  } while (Dot(along, along) < 0.01);
  return std::cos(config_.surface_angle) * along / std::sqrt(Dot(along, along)) +
         std::sin(config_.surface_angle) * normal_;
}

std::vector<Edge> MakeEdges(const Setup& setup, long count, std::uint64_t seed) {
  std::vector<Edge> edges;
  EdgeMaker maker(setup, seed);
  for (long tries = 0; std::ssize(edges) < count && tries < 400 * count; ++tries) {
    if (const std::optional<Edge> edge = maker.Next()) edges.push_back(*edge);
  }
  return edges;
}

}  // namespace clipc::study
