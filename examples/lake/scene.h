// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <vector>

#include <clipc/runtime/clip_plane.h>
#include <clipc/runtime/mirror.h>

#include "tools/harness/camera.h"
#include "tools/harness/check.h"
#include "tools/harness/mesh.h"

// The lake of docs/lake.md and docs/lake-vulkan.md, whatever draws it.
namespace lake {

using namespace clipc::harness;
namespace runtime = clipc::runtime;

constexpr int kWidth = 960, kHeight = 600, kShadow = 2048;
constexpr runtime::Plane kWater{0, 1, 0, 0};  // keeps y >= 0
constexpr std::array<float, 4> kSky = {0.62F, 0.78F, 0.92F, 1};

// The constant buffers of lake.hlsl, as Direct3D lays them out.
struct ViewConstants {
  std::array<float, 16> view_projection, to_light;
  runtime::Float4 water;
};
struct ObjectConstants {
  std::array<float, 16> world;
  float color[4];
};
struct Object {
  std::size_t mesh;
  ObjectConstants constants;
};

struct Scene {
  std::vector<Mesh> meshes = {Teapot(24), Torus(32, 1.3, 0.3), Ground(9, 1), Ground(60, 1)};
  std::vector<Object> land, surface;
  ViewConstants sunlight, mirrored, seen;
};

inline Scene MakeScene() {
  const auto at = [](double x, double y, double z, double size, double angle) {
    return Floats(Multiply(Multiply(Scaling(size), Rotation(angle)), Translation(x, y, z)));
  };
  Scene scene;
  scene.land = {{0, {at(-1.2, 0.5, 5, 1, 0.5), {0.9F, 0.5F, 0.3F, 1}}},
                {1, {at(1.8, 0.1, 5.5, 0.8, 0), {0.9F, 0.8F, 0.3F, 1}}},
                {0, {at(2.5, 1.3, 9.5, 1.4, 2.5), {0.4F, 0.6F, 0.9F, 1}}},
                {2, {at(0, 0.2, 16, 1, 0), {0.55F, 0.62F, 0.35F, 1}}}};
  scene.surface = {{3, {at(0, 0, 0, 1, 0), {0.05F, 0.2F, 0.25F, 1}}}};
  const Matrix view = LookAt({0, 2, -1}, {0, 0.3, 6});
  const Matrix projection = Perspective(0.75, double{kWidth} / kHeight, 0.5, 200);
  Camera sun;
  sun.orthographic = true, sun.half_height = 18, sun.aspect = 1, sun.near = 1, sun.far = 60;
  const Matrix light = Multiply(LookAt({10, 16, 2}, {0, 0, 10}), sun.Projection());
  scene.sunlight = {Floats(light), {}, {}};

  // The image in the water is the mirrored view of what is above it.
  const Matrix mirrored = Multiply(Check(runtime::MirrorMatrix(kWater)), view);
  const auto water = Check(runtime::ClipPlaneFromWorld(kWater, mirrored, projection));
  scene.mirrored = {Floats(Multiply(mirrored, projection)), Floats(light), water.constant};
  // A plane of zeros clips nothing.
  scene.seen = {Floats(Multiply(view, projection)), Floats(light), {}};
  return scene;
}

}  // namespace lake
