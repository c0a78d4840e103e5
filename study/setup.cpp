// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/setup.h"

#include <algorithm>
#include <cmath>

#include "runtime/mirror.h"
#include "study/visible_cut.h"

namespace clipc::study {

Plane PlaneThroughPoint(Vector direction, Vector point) {
  const Vector n = Unit(direction);
  return {n.x, n.y, n.z, -Dot(n, point)};
}

void CutThrough(Config& config, Vector direction, Vector point) {
  config.view_plane = PlaneThroughPoint(direction, point);
  config.nearest = point.z / 2, config.farthest = 2 * point.z;
}

double Setup::EdgeInHalfImages() const {
  const Camera& camera = config.camera;
  return config.edge_length * (camera.orthographic ? 1 : 1 / camera.HalfHeightAt(1));
}

Vector OriginInView(const Matrix& to_view) { return RowOf(to_view, 3); }

std::optional<Vector> RandomCut(const Setup& setup, Random& random) {
  if (!setup.cut.empty()) return RandomPlace(setup.cut, setup.config.camera, random);
  const Config& config = setup.config;
  const Camera& camera = config.camera;
  const Matrix& p = setup.projection;
  const Vector normal = NormalOf(config.view_plane);
  const double z = random.Magnitude(config.nearest, config.farthest),
               w = camera.orthographic ? 1 : z;
  const double x = random.Between(-1, 1), y = random.Between(-1, 1);
  const Vector at{(x - camera.offset_x) / p.m[0][0] * w, (y - camera.offset_y) / p.m[1][1] * w, z};
  const Vector point = at - (Dot(normal, at) + config.view_plane.w) * normal;
  if (point.z < config.nearest / 2 || point.z > config.farthest * 2 || point.z < camera.near)
    return std::nullopt;
  const double now_w = camera.orthographic ? 1 : point.z;
  const double to_x = point.x * p.m[0][0] + camera.offset_x * now_w;
  const double to_y = point.y * p.m[1][1] + camera.offset_y * now_w;
  if (std::fabs(to_x) > now_w || std::fabs(to_y) > now_w) return std::nullopt;
  return point;
}

std::vector<Vector> RandomCuts(const Setup& setup, std::size_t count) {
  Random random(1);
  std::vector<Vector> cuts;
  for (int tries = 0; cuts.size() < count && tries < 80000; ++tries) {
    if (const std::optional<Vector> cut = RandomCut(setup, random)) cuts.push_back(*cut);
  }
  return cuts;
}

void Compose(Setup& setup) {
  setup.world_view = Multiply(setup.world, setup.view);
  setup.world_view_projection = Multiply(setup.world_view, setup.projection);
  setup.to_object = InverseOf(ConvertTo<double>(setup.world_view));
}

Setup Prepare(const Config& config) {
  Setup setup;
  setup.config = config;
  Camera& camera = setup.config.camera;
  camera.yaw += 0.3, camera.pitch -= 0.2, camera.roll += 0.1;
  const double away[3] = {0.8, -0.5, 0.33};
  for (int i = 0; i < 3; ++i) camera.eye[i] += away[i] * config.world_offset;
  setup.view = camera.View();
  Matrix view_to_world = camera.ViewToWorld();
  if (config.mirrored) {
    // The mirror goes through the eye, so that offsets do not change.
    const Plane mirror =
        PlaneThroughPoint({0.3, 0.9, -0.2}, {camera.eye[0], camera.eye[1], camera.eye[2]});
    const Matrix mirrored = runtime::MirrorMatrix(mirror).value;
    setup.view = Multiply(mirrored, setup.view);
    view_to_world = Multiply(view_to_world, mirrored);
  }
  setup.projection = camera.Projection();

  // The object is where the surfaces are, turned in a way of its own.
  setup.world = harness::Rotation(1.1, 0.4, -0.7);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) setup.world.m[i][j] *= config.scale[i];
  }
  const double depth = std::sqrt(config.nearest * config.farthest);
  for (int j = 0; j < 3; ++j)
    setup.world.m[3][j] =
        depth * view_to_world.m[2][j] + view_to_world.m[3][j] + config.mesh_offset * away[j];
  Compose(setup);

  // The world-space plane is the truth; the other two follow from it.
  const Plane unit = PlaneBefore(setup.view, config.view_plane);
  const double s = config.plane_scale;
  setup.world_plane = {unit.x * s, unit.y * s, unit.z * s, unit.w * s};
  setup.view_plane = PlaneBefore(view_to_world, setup.world_plane);
  setup.object_plane = PlaneBefore(setup.world, setup.world_plane);
  return setup;
}

}  // namespace clipc::study
