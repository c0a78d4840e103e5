// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/study/edges.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace clipc::study {
namespace {

struct Edge {
  Vec4<float> ends[2];        // object space
  Wide distances[2];          // the truth, of different signs
  Vec4<long double> clip[2];  // positions, without float's rounding
};

struct Point {
  long double x, y;  // pixels
};

Point PixelOf(const Vec4<long double>& p) {
  return {p[0] / p[3] * (kPictureWidth / 2), p[1] / p[3] * (kPictureHeight / 2)};
}

Point PointAt(const Edge& edge, long double t) {
  Vec4<long double> p;
  for (int i = 0; i < 4; ++i) p[i] = edge.clip[0][i] + t * (edge.clip[1][i] - edge.clip[0][i]);
  return PixelOf(p);
}

double Between(const Point& a, const Point& b) {
  return static_cast<double>(std::hypot(a.x - b.x, a.y - b.y));
}

class EdgeMaker {
 public:
  EdgeMaker(const Setup& setup, std::uint64_t seed)
      : setup_(setup), config_(setup.config), random_(seed) {}

  // An edge that crosses the plane; none if the random numbers do not give one.
  std::optional<Edge> Next() {
    const std::optional<Vector> point = PointOnPlane();
    if (!point) return std::nullopt;
    const Vector direction = ChooseDirection();
    const double size = config_.camera.orthographic ? config_.camera.half_height : point->z;
    const double length = config_.edge_length * size, before = random_.Between(0.2, 0.8);
    Edge edge;
    const Mat4<double> to_object = ConvertTo<double>(setup_.to_object);
    for (int end = 0; end < 2; ++end) {
      const Vector place = *point + (end == 0 ? -before : 1 - before) * length * direction;
      edge.ends[end] =
          ConvertTo<float>(Transform(Vec4<double>{{place.x, place.y, place.z, 1}}, to_object));
      edge.ends[end][3] = 1;
      edge.distances[end] = Dot(Transform(ConvertTo<Wide>(edge.ends[end]), world_), plane_);
      edge.clip[end] = ToClip(edge.ends[end]);
    }
    if ((edge.distances[0] >= 0) == (edge.distances[1] >= 0)) return std::nullopt;
    return edge;
  }

  // The position in clip space, without rounding.
  Vec4<long double> ToClip(const Vec4<float>& vertex) const {
    return ConvertTo<long double>(
        Transform(Transform(Transform(ConvertTo<Wide>(vertex), world_), view_), projection_));
  }

 private:
  // A point of the frustum, moved to the plane along the normal, that is still in the picture.
  std::optional<Vector> PointOnPlane() {
    const Camera& camera = config_.camera;
    const Matrix& p = setup_.projection;
    const double z = random_.Magnitude(config_.nearest, config_.farthest),
                 w = camera.orthographic ? 1 : z;
    const double x = random_.Between(-1, 1), y = random_.Between(-1, 1);
    const Vector at{(x - camera.offset_x) / p.m[0][0] * w, (y - camera.offset_y) / p.m[1][1] * w,
                    z};
    const Vector point = at - (Dot(normal_, at) + config_.view_plane.w) * normal_;
    if (point.z < config_.nearest / 2 || point.z > config_.farthest * 2 || point.z < camera.near)
      return std::nullopt;
    const double now_w = camera.orthographic ? 1 : point.z;
    const double to_x = point.x * p.m[0][0] + camera.offset_x * now_w;
    const double to_y = point.y * p.m[1][1] + camera.offset_y * now_w;
    if (std::fabs(to_x) > now_w || std::fabs(to_y) > now_w) return std::nullopt;
    return point;
  }

  Vector ChooseDirection() {
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

  const Setup& setup_;
  const Config& config_;
  const Vector normal_{config_.view_plane.x, config_.view_plane.y, config_.view_plane.z};
  Random random_;
  Mat4<Wide> world_ = ConvertTo<Wide>(setup_.world), view_ = ConvertTo<Wide>(setup_.view);
  Mat4<Wide> projection_ = ConvertTo<Wide>(setup_.projection);
  Vec4<Wide> plane_ = ConvertTo<Wide>(setup_.world_plane);
};

// Pixels between the true cut and the method's; infinity where a distance is not a number.
double Displacement(const Edge& edge, const Distance& distance, bool makes_vertices,
                    const EdgeMaker& maker) {
  const double d[2] = {distance(edge.ends[0]), distance(edge.ends[1])};
  if (!std::isfinite(d[0]) || !std::isfinite(d[1])) return INFINITY;
  const Point right = PointAt(
      edge, static_cast<long double>(edge.distances[0] / (edge.distances[0] - edge.distances[1])));
  const bool kept[2] = {d[0] >= 0, d[1] >= 0};
  if (kept[0] != kept[1]) {
    const long double first = d[0], second = d[1];
    if (makes_vertices) {
      Vec4<float> cut = edge.ends[0];
      for (int i = 0; i < 3; ++i) {
        const double from = static_cast<double>(edge.ends[0][i]),
                     to = static_cast<double>(edge.ends[1][i]);
        cut[i] = static_cast<float>(from + d[0] / (d[0] - d[1]) * (to - from));
      }
      return Between(PixelOf(maker.ToClip(cut)), right);
    }
    return Between(PointAt(edge, first / (first - second)), right);
  }
  // Kept whole: the cut moved to the end that should have been dropped; dropped whole: to the one
  // to be kept.
  const bool first_is_kept = edge.distances[0] >= 0;
  return Between(PointAt(edge, first_is_kept == kept[0] ? 1 : 0), right);
}

EdgeErrors Summary(const std::string& method, std::vector<double> pixels) {
  EdgeErrors errors;
  errors.method = method;
  errors.applies = true;
  errors.edges = static_cast<long>(pixels.size());
  if (pixels.empty()) return errors;
  std::ranges::sort(pixels);
  const auto at = [&](double share) {
    return pixels[std::min(pixels.size() - 1,
                           static_cast<std::size_t>(share * static_cast<double>(pixels.size())))];
  };
  errors.median = at(0.5), errors.p99 = at(0.99), errors.largest = pixels.back();
  errors.not_finite = static_cast<long>(std::ranges::count(pixels, INFINITY));
  const auto over = pixels.end() - std::ranges::upper_bound(pixels, 0.5);
  errors.over_half = static_cast<double>(over) / static_cast<double>(pixels.size());
  return errors;
}

}  // namespace

std::vector<EdgeErrors> MeasureEdges(const Config& config, const std::vector<Method>& methods,
                                     long count, std::uint64_t seed) {
  const Setup setup = Prepare(config);
  std::vector<std::optional<Distance>> distances;
  for (const Method& method : methods) distances.push_back(method.prepare(setup));
  std::vector<std::vector<double>> pixels(methods.size());
  EdgeMaker maker(setup, seed);
  long made = 0;
  for (long tries = 0; made < count && tries < 400 * count; ++tries) {
    const std::optional<Edge> edge = maker.Next();
    if (!edge) continue;
    ++made;
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (distances[i])
        pixels[i].push_back(Displacement(*edge, *distances[i], methods[i].makes_vertices, maker));
    }
  }
  std::vector<EdgeErrors> errors;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    errors.push_back(distances[i] ? Summary(methods[i].name, std::move(pixels[i]))
                                  : EdgeErrors{.method = methods[i].name});
  }
  return errors;
}

}  // namespace clipc::study
