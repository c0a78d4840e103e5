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

// Where a method cuts edges: the shares of them, and how far from the right place it is in the
// image.
struct Cuts {
  std::vector<long double> shares;
  std::vector<Point> off;
};

// The cuts of the edges; none where the method does not apply.
std::optional<Cuts> CutsOf(const Setup& setup, const Method& method,
                           const std::vector<Edge>& edges) {
  const std::optional<Distance> distance = method.prepare(setup);
  if (!distance) return std::nullopt;
  const Position position = PositionBy(method.order, setup);
  Cuts cuts;
  for (const Edge& edge : edges) {
    const Vec4<float>(&ends)[2] = edge.ends;
    const long double share = CutShare(edge, {(*distance)(ends[0]), (*distance)(ends[1])});
    const Point drawn = SeenEdge(setup, position(ends[0]), position(ends[1])).At(share),
                right = SeenEdge(setup, edge).At(TrueShare(edge));
    cuts.shares.push_back(share), cuts.off.push_back({drawn.x - right.x, drawn.y - right.y});
  }
  return cuts;
}

double At(std::vector<double>& pixels, double share) {
  std::ranges::sort(pixels);
  return pixels[static_cast<std::size_t>(share * static_cast<double>(pixels.size() - 1))];
}

}  // namespace

std::vector<Flicker> MeasureFlicker(const Config& config, const std::vector<Method>& methods,
                                    int frames, double step, long count, std::uint64_t seed) {
  const Setup first = Prepare(config);
  const std::vector<Edge> edges = MakeEdges(first, count, seed);
  std::vector<Flicker> all;
  for (const Method& method : methods) {
    auto before = CutsOf(first, method, edges);
    std::vector<double> along_surface, in_image;
    for (int frame = 1; before && frame < frames; ++frame) {
      const Setup setup = Panned(first, frame * step);
      auto now = CutsOf(setup, method, edges);
      for (std::size_t i = 0; now && i < edges.size(); ++i) {
        const SeenEdge seen(setup, edges[i]);
        along_surface.push_back(Between(seen.At(before->shares[i]), seen.At(now->shares[i])));
        in_image.push_back(Between(before->off[i], now->off[i]));
      }
      before = std::move(now);
    }
    Flicker& flicker = all.emplace_back(Flicker{.method = method.name});
    if (!before || along_surface.empty()) continue;
    flicker.applies = true;
    flicker.median = At(along_surface, 0.5), flicker.p99 = At(along_surface, 0.99);
    flicker.largest = along_surface.back(), flicker.p99_in_image = At(in_image, 0.99);
  }
  return all;
}

}  // namespace clipc::study
