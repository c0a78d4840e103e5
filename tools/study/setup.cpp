// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/study/setup.h"

#include <cmath>

#include "runtime/clip_plane.h"

namespace clipc::study {

Plane PlaneThroughPoint(Vector direction, Vector point) {
  const Vector n = Unit(direction);
  return {n.x, n.y, n.z, -Dot(n, point)};
}

Setup Prepare(const Config& config) {
  Setup setup;
  setup.config = config;
  Camera& camera = setup.config.camera;
  camera.yaw += 0.3, camera.pitch -= 0.2, camera.roll += 0.1;
  const double away[3] = {0.8, -0.5, 0.33};
  for (int i = 0; i < 3; ++i) camera.eye[i] += away[i] * config.world_offset;
  setup.view = camera.View();
  setup.projection = camera.Projection();

  // The object stands where the surfaces are, turned in a way of its own.
  setup.world = harness::Rotation(1.1, 0.4, -0.7);
  const Matrix view_to_world = camera.ViewToWorld();
  const double depth = std::sqrt(config.nearest * config.farthest);
  for (int j = 0; j < 3; ++j)
    setup.world.m[3][j] =
        depth * view_to_world.m[2][j] + view_to_world.m[3][j] + config.mesh_offset * away[j];
  setup.world_view = Multiply(setup.world, setup.view);
  setup.world_view_projection = Multiply(setup.world_view, setup.projection);
  const Mat4<double> inverse = InverseOf(ConvertTo<double>(setup.world_view));
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) setup.to_object.m[i][j] = inverse.m[i][j];
  }

  // The world-space plane is the truth; the other two follow from it.
  const Plane unit = PlaneBefore(setup.view, config.view_plane);
  const double s = config.plane_scale;
  setup.world_plane = {unit.x * s, unit.y * s, unit.z * s, unit.w * s};
  setup.view_plane = PlaneBefore(view_to_world, setup.world_plane);
  setup.object_plane = PlaneBefore(setup.world, setup.world_plane);
  return setup;
}

}  // namespace clipc::study
