// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/scene_measure.h"

#include <algorithm>
#include <cmath>

#include "study/edges.h"
#include "study/visible_cut.h"

namespace clipc::study {
namespace {

Vector CornerOf(const runtime::Box& box, int corner) {
  const auto at = [&](int axis) {
    return static_cast<double>((corner >> axis & 1) != 0 ? box.high[axis] : box.low[axis]);
  };
  return {at(0), at(1), at(2)};
}

Vector Through(const Matrix& matrix, Vector p) {
  const auto& m = matrix.m;
  const auto at = [&](int j) { return p.x * m[0][j] + p.y * m[1][j] + p.z * m[2][j] + m[3][j]; };
  return {at(0), at(1), at(2)};
}

// The arithmetic of the way in a scene whose shaders may multiply by several matrices.
Method ArithmeticOf(const Way& way, const Scene& scene) {
  if (way.space == PlaneSpace::kClip) return ClipSpaceBy(scene.means.order);
  if (way.space == PlaneSpace::kXyw1) return Xyw1SpaceBy(scene.means.order);
  return way.method();
}

}  // namespace

std::optional<Setup> SetupOf(const Camera& camera, const SceneObject& object, const Plane& plane) {
  Setup setup;
  setup.config.camera = camera;
  setup.world = object.world, setup.view = camera.View(), setup.projection = camera.Projection();
  Compose(setup);
  setup.world_plane = plane;
  setup.view_plane = PlaneBefore(camera.ViewToWorld(), plane);
  setup.object_plane = PlaneBefore(setup.world, plane);
  const Plane& v = setup.view_plane;
  const double length = NormalLength(v);
  if (!(length > 0)) return std::nullopt;
  setup.config.view_plane = {v.x / length, v.y / length, v.z / length, v.w / length};

  double nearest = INFINITY, farthest = camera.near, diagonal = 0;
  const Vector first = Through(setup.world_view, CornerOf(object.box, 0));
  for (int corner = 0; corner < 8; ++corner) {
    const Vector place = Through(setup.world_view, CornerOf(object.box, corner));
    nearest = std::min(nearest, place.z), farthest = std::max(farthest, place.z);
    diagonal = std::max(diagonal, std::sqrt(Dot(place - first, place - first)));
  }
  nearest = std::max(nearest, camera.near);
  if (!camera.infinite) farthest = std::min(farthest, camera.far);
  if (!(farthest > nearest)) return std::nullopt;
  setup.cut = CutOfBox(VisibleCut(camera, setup.config.view_plane, nearest, farthest), object.box,
                       setup.world_view);
  if (setup.cut.size() < 3) return std::nullopt;
  // Edges as long as a twentieth of the depth, or as half the object where that is less.
  const double depth = camera.orthographic ? camera.half_height : setup.cut.front().z;
  setup.config.edge_length = std::min(0.05, diagonal / 2 / depth);
  return setup;
}

std::optional<double> MeasureObject(const Scene& scene, const Camera& camera,
                                    const SceneObject& object, std::uint8_t needed, const Way& way,
                                    long edges, std::uint64_t seed) {
  const Method method = ArithmeticOf(way, scene);
  double worst = 0;
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    if ((needed >> i & 1) == 0) continue;
    const std::optional<Setup> setup = SetupOf(camera, object, scene.planes[i].plane);
    if (!setup) continue;
    const EdgeErrors errors = MeasureEdges(*setup, {method}, edges, seed).front();
    if (!errors.applies) return std::nullopt;
    worst = std::max(worst, errors.p99);
  }
  return worst * scene.picture_height / kPictureHeight;
}

}  // namespace clipc::study
