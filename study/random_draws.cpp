// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/random_draws.h"

#include <cmath>
#include <numbers>

#include "study/edges.h"
#include "study/way.h"

namespace clipc::study {
namespace {

RandomDraw OneDraw(Random& random) {
  RandomDraw draw;
  Config& config = draw.config;
  Camera& camera = config.camera;
  camera.near = random.Magnitude(1e-3, 1);
  camera.far = camera.near * random.Magnitude(1e2, 1e7);
  camera.orthographic = random.Below(8) == 0;
  camera.reversed = random.Below(4) == 0;
  camera.infinite = !camera.orthographic && random.Below(4) == 0;
  camera.fov = random.Magnitude(10, 120);
  camera.aspect = random.Between(1, 2.4);
  if (random.Below(3) == 0)
    camera.offset_x = random.Between(-0.2, 0.2), camera.offset_y = random.Between(-0.2, 0.2);
  camera.yaw = random.Between(-3, 3), camera.pitch = random.Between(-1, 1);
  if (random.Below(2) == 0) config.world_offset = random.Magnitude(1, 1e6);
  // The cut lies well inside the frustum.
  const double depth =
      camera.near * random.Magnitude(4, std::min(1e5, camera.far / camera.near / 4));
  camera.half_height = depth;
  Vector n = random.Direction();
  if (n.z < 0 && random.Below(3) != 0) n.z = -n.z;  // mostly with the eye on the clipped side
  CutThrough(config, n, {0, 0, depth});
  config.surface_angle = random.Magnitude(5, 90) * std::numbers::pi / 180;

  DrawFacts& facts = draw.facts;
  facts.camera = camera;
  CutFacts& cut = facts.cuts.front();
  cut.view_plane = config.view_plane;
  facts.picture_height = kPictureHeight, facts.sine = std::sin(config.surface_angle);
  const Setup setup = Prepare(config);
  cut.reach = ReachOf(setup, OriginInView(setup.world_view));
  cut.world_reach = ReachOf(setup, OriginInView(setup.view));
  const std::uint32_t machine = random.Below(5);
  facts.means.clip_distances = machine < 3;
  facts.means.user_planes = machine == 3;
  facts.means.can_discard = machine != 3 || random.Below(2) == 0;
  facts.means.rigid = random.Below(4) != 0;
  facts.means.whole_pass = true;  // the draw is alone
  return draw;
}

}  // namespace

std::vector<RandomDraw> RandomDraws(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<RandomDraw> draws;
  for (int i = 0; i < count; ++i) draws.push_back(OneDraw(random));
  return draws;
}

MeasuredWay MeasureWay(const RandomDraw& draw, const std::string& way, long edges,
                       std::uint64_t seed) {
  const EdgeErrors errors =
      MeasureEdges(draw.config, {WayNamed(way).method()}, edges, seed).front();
  return {errors.applies && errors.edges == edges, errors.p99};
}

}  // namespace clipc::study
