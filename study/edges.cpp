// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/edges.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "study/edge_maker.h"

namespace clipc::study {
namespace {

// The distance in pixels between the true cut and the method's; infinity where a distance is not a
// number.
double Displacement(const Setup& setup, const Edge& edge, const SeenEdge& seen, Point right,
                    const Distance& distance, bool makes_vertices) {
  const double d[2] = {distance(edge.ends[0]), distance(edge.ends[1])};
  if (!std::isfinite(d[0]) || !std::isfinite(d[1])) return INFINITY;
  if (!makes_vertices || (d[0] >= 0) == (d[1] >= 0))
    return Between(seen.At(CutShare(edge, d)), right);
  Vec4<float> cut = edge.ends[0];
  for (int i = 0; i < 3; ++i) {
    const double from = static_cast<double>(edge.ends[0][i]),
                 to = static_cast<double>(edge.ends[1][i]);
    cut[i] = static_cast<float>(from + d[0] / (d[0] - d[1]) * (to - from));
  }
  return Between(PointOf(setup, cut), right);
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
  return errors;
}

// The displacements of `count` edges for each method; none for a method that does not apply.
std::vector<std::optional<std::vector<double>>> PixelsOf(const Setup& setup,
                                                         const std::vector<Method>& methods,
                                                         long count, std::uint64_t seed) {
  std::vector<std::optional<Distance>> distances;
  std::vector<std::optional<std::vector<double>>> pixels;
  for (const Method& method : methods) {
    pixels.emplace_back();
    if (distances.emplace_back(method.prepare(setup))) pixels.back().emplace();
  }
  for (const Edge& edge : MakeEdges(setup, count, seed)) {
    const SeenEdge seen(setup, edge);
    const Point right = seen.At(TrueShare(edge));
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (distances[i])
        pixels[i]->push_back(
            Displacement(setup, edge, seen, right, *distances[i], methods[i].makes_vertices));
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
std::vector<std::optional<std::vector<double>>> OverViews(const Config& config,
                                                          const std::vector<Method>& methods,
                                                          long count, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::optional<std::vector<double>>> all(methods.size(), std::vector<double>());
  for (int view = 0; view < kViews; ++view) {
    const auto pixels = PixelsOf(Prepare(Nearby(config, random)), methods, count, seed + 1 + view);
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (!pixels[i]) all[i].reset();
      if (all[i]) all[i]->insert(all[i]->end(), pixels[i]->begin(), pixels[i]->end());
    }
  }
  return all;
}

std::vector<EdgeErrors> Summaries(const std::vector<Method>& methods,
                                  std::vector<std::optional<std::vector<double>>> pixels) {
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

std::vector<double> DisplacementsOverViews(const Config& config, const Method& method, long count,
                                           std::uint64_t seed) {
  return OverViews(config, {method}, count, seed).front().value_or(std::vector<double>());
}

std::vector<EdgeErrors> MeasureViews(const Config& config, const std::vector<Method>& methods,
                                     long count, std::uint64_t seed) {
  return Summaries(methods, OverViews(config, methods, count, seed));
}

EdgeErrors MeasureDirections(double ratio, const Method& method, int planes, long count,
                             std::uint64_t seed) {
  Random random(seed);
  std::vector<double> all;
  for (int i = 0; i < planes; ++i) {
    Config config;
    config.camera.far = 1e7;
    Vector normal = random.Direction();
    // The eye on the clipped side, and the plane before it.
    normal.z = std::max(std::fabs(normal.z), 0.2);
    normal = Unit(normal);
    const double depth = ratio * config.camera.near / normal.z;
    CutThrough(config, normal, {0, 0, depth});
    config.camera.yaw = random.Between(-3, 3), config.camera.pitch = random.Between(-1, 1);
    const auto pixels = PixelsOf(Prepare(config), {method}, count, seed + 1 + i).front();
    if (pixels) all.insert(all.end(), pixels->begin(), pixels->end());
  }
  return all.empty() ? EdgeErrors{.method = method.name} : Summary(method.name, std::move(all));
}

}  // namespace clipc::study
