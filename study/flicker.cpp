// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/flicker.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "study/edge_maker.h"

namespace clipc::study {
namespace {

// The setup of the same world, seen by a camera that has turned by that angle.
Setup Panned(const Setup& first, double yaw) {
  Setup setup = first;
  Camera& camera = setup.config.camera;
  camera.yaw += yaw;
  setup.view = camera.View();
  Compose(setup);
  setup.view_plane = PlaneBefore(camera.ViewToWorld(), setup.world_plane);
  return setup;
}

// The shares of the edges at which the method cuts them; none where it does not apply.
std::optional<std::vector<long double>> SharesOf(const Setup& setup, const Method& method,
                                                 const std::vector<Edge>& edges) {
  const std::optional<Distance> distance = method.prepare(setup);
  if (!distance) return std::nullopt;
  std::vector<long double> shares;
  shares.reserve(edges.size());
  for (const Edge& edge : edges)
    shares.push_back(CutShare(edge, {(*distance)(edge.ends[0]), (*distance)(edge.ends[1])}));
  return shares;
}

Flicker FlickerOf(const std::string& method, std::vector<double> pixels) {
  std::ranges::sort(pixels);
  const auto at = [&](double share) {
    return pixels[static_cast<std::size_t>(share * static_cast<double>(pixels.size() - 1))];
  };
  return {method, true, at(0.5), at(0.99), pixels.back()};
}

}  // namespace

std::vector<Flicker> MeasureFlicker(const Config& config, const std::vector<Method>& methods,
                                    int frames, double step, long count, std::uint64_t seed) {
  const Setup first = Prepare(config);
  const std::vector<Edge> edges = MakeEdges(first, count, seed);
  std::vector<Flicker> all;
  for (const Method& method : methods) {
    auto before = SharesOf(first, method, edges);
    std::vector<double> pixels;
    for (int frame = 1; before && frame < frames; ++frame) {
      const Setup setup = Panned(first, frame * step);
      auto now = SharesOf(setup, method, edges);
      for (std::size_t i = 0; now && i < edges.size(); ++i) {
        const SeenEdge seen(setup, edges[i]);
        pixels.push_back(Between(seen.At((*before)[i]), seen.At((*now)[i])));
      }
      before = std::move(now);
    }
    all.push_back(before && !pixels.empty() ? FlickerOf(method.name, std::move(pixels))
                                            : Flicker{.method = method.name});
  }
  return all;
}

}  // namespace clipc::study
