// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/edges.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "study/edge_maker.h"

namespace clipc::study {
namespace {

// A method in a draw.
struct InDraw {
  Distance distance;
  Position position;
  bool makes_vertices;
};

// Adds the distances in pixels between the true cut and the method's; infinity where a distance is
// not a number.
void AddDisplacement(const Setup& setup, const Edge& edge, const SeenEdge& seen, Point right,
                     const InDraw& method, Displacements& to) {
  const double d[2] = {method.distance(edge.ends[0]), method.distance(edge.ends[1])};
  if (!std::isfinite(d[0]) || !std::isfinite(d[1])) {
    to.along_surface.push_back(INFINITY), to.in_image.push_back(INFINITY);
    return;
  }
  if (!method.makes_vertices || (d[0] >= 0) == (d[1] >= 0)) {
    const long double share = CutShare(edge, d);
    const SeenEdge drawn(setup, method.position(edge.ends[0]), method.position(edge.ends[1]));
    to.along_surface.push_back(Between(seen.At(share), right));
    to.in_image.push_back(Between(drawn.At(share), right));
    return;
  }
  Vec4<float> cut = edge.ends[0];
  for (int i = 0; i < 3; ++i) {
    const double from = static_cast<double>(edge.ends[0][i]),
                 to_end = static_cast<double>(edge.ends[1][i]);
    cut[i] = static_cast<float>(from + d[0] / (d[0] - d[1]) * (to_end - from));
  }
  to.along_surface.push_back(Between(PointOf(setup, cut), right));
  to.in_image.push_back(Between(PointOfPosition(setup, method.position(cut)), right));
}

EdgeErrors Summary(const std::string& method, Displacements pixels) {
  EdgeErrors errors;
  errors.method = method;
  errors.applies = true;
  errors.edges = static_cast<long>(pixels.along_surface.size());
  if (pixels.along_surface.empty()) return errors;
  const auto at = [](std::vector<double>& all, double share) {
    std::ranges::sort(all);
    return all[std::min(all.size() - 1,
                        static_cast<std::size_t>(share * static_cast<double>(all.size())))];
  };
  errors.median = at(pixels.along_surface, 0.5), errors.p99 = at(pixels.along_surface, 0.99);
  errors.largest = pixels.along_surface.back();
  errors.p99_in_image = at(pixels.in_image, 0.99);
  errors.not_finite = static_cast<long>(std::ranges::count(pixels.along_surface, INFINITY));
  return errors;
}

void Append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}
void Append(Displacements& to, const Displacements& from) {
  Append(to.along_surface, from.along_surface), Append(to.in_image, from.in_image);
}

// The displacements of `count` edges for each method; none for a method that does not apply.
std::vector<std::optional<Displacements>> PixelsOf(const Setup& setup,
                                                   const std::vector<Method>& methods, long count,
                                                   std::uint64_t seed) {
  std::vector<std::optional<InDraw>> in_draw;
  std::vector<std::optional<Displacements>> pixels;
  for (const Method& method : methods) {
    pixels.emplace_back(), in_draw.emplace_back();
    if (auto distance = method.prepare(setup)) {
      pixels.back().emplace();
      in_draw.back() = {*distance, PositionBy(method.order, setup), method.makes_vertices};
    }
  }
  for (const Edge& edge : MakeEdges(setup, count, seed)) {
    const SeenEdge seen(setup, edge);
    const Point right = seen.At(TrueShare(edge));
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (in_draw[i]) AddDisplacement(setup, edge, seen, right, *in_draw[i], *pixels[i]);
    }
  }
  return pixels;
}

// A config whose numbers differ from those of `config` in most of their digits, but by a hundredth
// at most; its plane goes through a visible point of the other plane.
Config Nearby(const Config& config, Random& random) {
  const Setup setup = Prepare(config);
  std::optional<Vector> point;
  for (int tries = 0; !point && tries < 1000; ++tries) point = RandomCut(setup, random);
  if (!point) return config;
  Config near = config;
  near.view_plane =
      PlaneThroughPoint(NormalOf(config.view_plane) + 1e-3 * random.Direction(), *point);
  near.camera.yaw += random.Between(-0.01, 0.01);
  near.camera.pitch += random.Between(-0.01, 0.01);
  near.world_offset *= random.Between(0.99, 1.01);
  near.mesh_offset *= random.Between(0.99, 1.01);
  return near;
}

// The displacements of `count` edges in each view for each method; none for a method that does not
// apply in all of them.
std::vector<std::optional<Displacements>> OverViews(const Config& config,
                                                    const std::vector<Method>& methods, long count,
                                                    std::uint64_t seed) {
  Random random(seed);
  std::vector<std::optional<Displacements>> all(methods.size(), Displacements());
  for (int view = 0; view < kViews; ++view) {
    const auto pixels = PixelsOf(Prepare(Nearby(config, random)), methods, count, seed + 1 + view);
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (!pixels[i]) all[i].reset();
      if (all[i]) Append(*all[i], *pixels[i]);
    }
  }
  return all;
}

std::vector<EdgeErrors> Summaries(const std::vector<Method>& methods,
                                  std::vector<std::optional<Displacements>> pixels) {
  std::vector<EdgeErrors> errors;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    errors.push_back(pixels[i] ? Summary(methods[i].name, std::move(*pixels[i]))
                               : EdgeErrors{.method = methods[i].name});
  }
  return errors;
}

}  // namespace

std::vector<EdgeErrors> MeasureEdges(const Config& config, const std::vector<Method>& methods,
                                     long count, std::uint64_t seed) {
  return Summaries(methods, PixelsOf(Prepare(config), methods, count, seed));
}

Displacements DisplacementsOverViews(const Config& config, const Method& method, long count,
                                     std::uint64_t seed) {
  return OverViews(config, {method}, count, seed).front().value_or(Displacements());
}

std::vector<EdgeErrors> MeasureViews(const Config& config, const std::vector<Method>& methods,
                                     long count, std::uint64_t seed) {
  return Summaries(methods, OverViews(config, methods, count, seed));
}

EdgeErrors MeasureDirections(double ratio, bool reversed, const Method& method, int planes,
                             long count, std::uint64_t seed) {
  Random random(seed);
  Displacements all;
  for (int i = 0; i < planes; ++i) {
    Config config;
    config.camera.far = 1e7, config.camera.reversed = reversed;
    Vector normal = random.Direction();
    // The eye on the clipped side, and the plane before it.
    normal.z = std::max(std::fabs(normal.z), 0.2);
    normal = Unit(normal);
    const double depth = ratio * config.camera.near / normal.z;
    CutThrough(config, normal, {0, 0, depth});
    config.camera.yaw = random.Between(-3, 3), config.camera.pitch = random.Between(-1, 1);
    const auto pixels = PixelsOf(Prepare(config), {method}, count, seed + 1 + i).front();
    if (pixels) Append(all, *pixels);
  }
  return all.along_surface.empty() ? EdgeErrors{.method = method.name}
                                   : Summary(method.name, std::move(all));
}

}  // namespace clipc::study
