// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/roundings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/clip_plane.h"
#include "study/edges.h"
#include "study/numbers.h"

namespace clipc::study {
namespace {

enum class Position { kShader, kRoundedOnce, kExact };

// The arithmetic of `xyw1` with these roundings.
Method With(const char* name, Position rounded, bool dot_is_exact, bool constant_is_exact) {
  return {name, [=](const Setup& setup) -> std::optional<Distance> {
            const auto made = Xyw1PlaneFromView(setup.view_plane, setup.projection);
            if (!made.ok()) return std::nullopt;
            const auto to_clip = ConvertTo<float>(setup.world_view_projection);
            const auto exact_to_clip = ConvertTo<Wide>(setup.world_view_projection);
            const Vec4<float> constant = VectorOf(made.value.constant);
            const auto exact_constant =
                constant_is_exact ? ConvertTo<Wide>(made.value.plane) : ConvertTo<Wide>(constant);
            return [=](const Vec4<float>& vertex) {
              Vec4<Wide> position = rounded == Position::kShader
                                        ? ConvertTo<Wide>(Transform(vertex, to_clip))
                                        : Transform(ConvertTo<Wide>(vertex), exact_to_clip);
              if (rounded == Position::kRoundedOnce)
                position = ConvertTo<Wide>(ConvertTo<float>(position));
              position = {{position[0], position[1], position[3], 1}};
              return dot_is_exact ? static_cast<double>(Dot(position, exact_constant))
                                  : static_cast<double>(Dot(ConvertTo<float>(position), constant));
            };
          }};
}

// A draw that nobody chose, at that field of view.
Config DrawAt(double fov, Random& random) {
  const Vector normal = random.Direction();
  const double depth = random.Magnitude(0.3, 3000);
  const double x = random.Between(-0.05, 0.05) * depth;
  const double y = random.Between(-0.05, 0.05) * depth;
  Config config;
  CutThrough(config, normal, {x, y, depth});
  config.least_sine = std::sin(5 * std::numbers::pi / 180);
  config.camera.fov = fov;
  config.camera.near = random.Magnitude(1e-3, 1) * depth / 2, config.camera.far = 100 * depth;
  if (random.Below(3) == 0) config.world_offset = random.Magnitude(1, 1e5);
  return config;
}

}  // namespace

std::vector<Method> Xyw1Roundings() {
  return {With("all", Position::kShader, false, false),
          With("without the dot product's", Position::kShader, true, false),
          With("nor the constant's", Position::kShader, true, true),
          With("the position's alone, once", Position::kRoundedOnce, true, true),
          With("none", Position::kExact, true, true)};
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
