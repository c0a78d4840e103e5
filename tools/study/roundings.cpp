// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/study/roundings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/clip_plane.h"
#include "tools/study/edges.h"
#include "tools/study/numbers.h"

namespace clipc::study {
namespace {

template <typename T>
Vec4<T> Xyw1(const Vec4<T>& position) {
  return {{position[0], position[1], position[3], 1}};
}

struct Parts {
  Mat4<float> to_clip;
  Mat4<Wide> exact_to_clip;
  Vec4<float> constant;
  Vec4<Wide> exact_constant;
};

using Formula = double (*)(const Parts&, const Vec4<float>& vertex);

Method With(const char* name, Formula formula) {
  return {name, [formula](const Setup& setup) -> std::optional<Distance> {
            const auto made = runtime::Xyw1PlaneFromView(setup.view_plane, setup.projection);
            if (!made.ok()) return std::nullopt;
            Parts parts;
            parts.to_clip = ConvertTo<float>(setup.world_view_projection);
            parts.exact_to_clip = ConvertTo<Wide>(setup.world_view_projection);
            parts.constant = VectorOf(made.value.constant);
            parts.exact_constant = ConvertTo<Wide>(made.value.plane);
            return [parts, formula](const Vec4<float>& vertex) { return formula(parts, vertex); };
          }};
}

// A draw that nobody chose, at that field of view.
Config DrawAt(double fov, Random& random) {
  const harness::Vector normal = random.Direction();
  const double depth = random.Magnitude(0.3, 3000);
  const double x = random.Between(-0.05, 0.05) * depth;
  const double y = random.Between(-0.05, 0.05) * depth;
  Config config;
  config.view_plane = PlaneThroughPoint(normal, {x, y, depth});
  config.nearest = depth / 2, config.farthest = 2 * depth;
  config.least_sine = std::sin(5 * std::numbers::pi / 180);
  config.camera.fov = fov;
  config.camera.near = random.Magnitude(1e-3, 1) * depth / 2, config.camera.far = 100 * depth;
  if (random.Below(3) == 0) config.world_offset = random.Magnitude(1, 1e5);
  return config;
}

}  // namespace

std::vector<Method> Xyw1Roundings() {
  return {
      With("all",
           [](const Parts& parts, const Vec4<float>& vertex) {
             return static_cast<double>(
                 Dot(Xyw1(Transform(vertex, parts.to_clip)), parts.constant));
           }),
      With("without the dot product's",
           [](const Parts& parts, const Vec4<float>& vertex) {
             const Vec4<Wide> position = ConvertTo<Wide>(Xyw1(Transform(vertex, parts.to_clip)));
             return static_cast<double>(Dot(position, ConvertTo<Wide>(parts.constant)));
           }),
      With("nor the constant's",
           [](const Parts& parts, const Vec4<float>& vertex) {
             const Vec4<Wide> position = ConvertTo<Wide>(Xyw1(Transform(vertex, parts.to_clip)));
             return static_cast<double>(Dot(position, parts.exact_constant));
           }),
      With("the position's alone, once",
           [](const Parts& parts, const Vec4<float>& vertex) {
             const Vec4<float> position =
                 ConvertTo<float>(Transform(ConvertTo<Wide>(vertex), parts.exact_to_clip));
             return static_cast<double>(Dot(ConvertTo<Wide>(Xyw1(position)), parts.exact_constant));
           }),
      With("none",
           [](const Parts& parts, const Vec4<float>& vertex) {
             const Vec4<Wide> position = Transform(ConvertTo<Wide>(vertex), parts.exact_to_clip);
             return static_cast<double>(Dot(Xyw1(position), parts.exact_constant));
           }),
  };
}

std::vector<RoundingCost> MeasureRoundings(double fov, int draws, long edges, std::uint64_t seed) {
  const std::vector<Method> methods = Xyw1Roundings();
  std::vector<RoundingCost> costs;
  for (const Method& method : methods) costs.emplace_back().rounding = method.name;
  Random random(seed);
  for (int draw = 0; draw < draws; ++draw) {
    const Config config = DrawAt(fov, random);
    const std::vector<EdgeErrors> errors =
        MeasureEdges(config, methods, edges, seed + static_cast<std::uint64_t>(draw));
    if (errors.front().edges < edges) continue;  // the plane is hardly in the picture
    for (std::size_t i = 0; i < costs.size(); ++i) {
      ++costs[i].draws;
      costs[i].mean += errors[i].p99;
      costs[i].worst = std::max(costs[i].worst, errors[i].p99);
      costs[i].over += errors[i].p99 > kXyw1Claim;
    }
  }
  for (RoundingCost& cost : costs) cost.mean /= std::max(cost.draws, 1);
  return costs;
}

}  // namespace clipc::study
