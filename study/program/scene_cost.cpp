// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/scene_cost.h"

#include "runtime/clip_plane.h"
#include "runtime/shader_variant.h"
#include "tools/harness/timing.h"

namespace clipc::study {
namespace {

// The plans of all objects of the scene.
std::vector<runtime::BoxPlan> PlansOf(const Scene& scene, Planes planes) {
  const auto every = static_cast<runtime::BoxPlan>((1u << scene.planes.size()) - 1);
  std::vector<runtime::BoxPlan> plans;
  for (const SceneObject& object : scene.objects) {
    if (planes == Planes::kNone || planes == Planes::kAll) {
      plans.push_back(planes == Planes::kAll ? every : 0);
      continue;
    }
    const ObjectPlan plan = PlanObject(object, scene.cameras.front().camera, scene.planes);
    std::uint8_t needed = plan.needed;
    if (planes == Planes::kTooFew) needed = static_cast<std::uint8_t>(needed & (needed - 1));
    plans.push_back(plan.culled ? runtime::kCulled : needed);
  }
  return plans;
}

}  // namespace

SceneDrawer::SceneDrawer(int width, int height) : studio_(width, height, false) {
  const Mesh mesh = TorusKnot(40, 8, 1);
  for (int planes = 0; planes <= 6; ++planes) {
    variants_.push_back(MakeCall(planes == 0 ? WayKind::kNone : WayKind::kObject, planes, false));
    variants_.back()->SetMesh(mesh);
  }
}

SceneDrawer::Drawn SceneDrawer::Draw(const Scene& scene, Planes planes) {
  studio_.Begin();
  glFinish();
  const double start = harness::ProcessSeconds();
  const Camera& camera = scene.cameras.front().camera;
  const Matrix view_projection = Multiply(camera.View(), camera.Projection());
  const std::vector<runtime::BoxPlan> plans = PlansOf(scene, planes);
  std::vector<std::uint32_t> order(plans.size());
  std::size_t first[8];
  runtime::OrderByPlaneCount(plans.data(), plans.size(), order.data(), first);
  Drawn drawn;
  for (std::size_t i = 0; i < first[7]; ++i) {
    const SceneObject& object = scene.objects[order[i]];
    const runtime::ShaderVariant variant = runtime::VariantOf(plans[order[i]]);
    WayConstants constants = {ConvertTo<float>(Multiply(object.world, view_projection)),
                              ConvertTo<float>(object.world),
                              {}};
    for (int slot = 0; slot < variant.plane_count; ++slot) {
      const Plane& plane = scene.planes[variant.planes[slot]].plane;
      constants.planes.push_back(
          VectorOf(ObjectPlaneFromWorld(plane, object.world).value.constant));
    }
    DrawCall& call = *variants_[variant.plane_count];
    call.SetConstants(constants);
    call.Draw();
    ++drawn.draws, drawn.planes += variant.plane_count;
  }
  glFinish();
  drawn.cpu_ms = 1e3 * (harness::ProcessSeconds() - start);
  drawn.rgba = studio_.Read().rgba;
  return drawn;
}

}  // namespace clipc::study
