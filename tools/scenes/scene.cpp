// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/scenes/scene.h"

#include <cstdlib>

#include "runtime/clip_plane.h"
#include "runtime/mirror.h"
#include "tools/harness/camera.h"
#include "tools/harness/mesh.h"

namespace clipc::scenes {
namespace {

using harness::Mesh;
using harness::Multiply;
using harness::Rotation;
using harness::Scaling;
using harness::Translation;
using runtime::Matrix;
using runtime::Plane;

Object MakeObject(const Mesh& mesh, double x, double y, double z, double size, double angle,
                  std::uint32_t color) {
  Object object;
  for (const std::uint32_t index : mesh.indices) {
    const float* p = mesh.vertices[index].position;
    object.vertices.push_back({{p[0], p[1], p[2]}, color});
  }
  object.world = Multiply(Multiply(Scaling(size), Rotation(angle)), Translation(x, y, z));
  return object;
}

}  // namespace

Scene MakeScene(int plane_count) {
  Scene scene;
  const Mesh teapot = harness::Teapot(12);
  const Mesh torus = harness::Torus(16, 1.3, 0.35);
  scene.objects = {MakeObject(teapot, -1.1, 0.21, 6.3, 1.3, 0.6, 0xFFCC7040),
                   MakeObject(teapot, 2.3, 0.13, 8.9, 1.5, 2.5, 0xFF5090D0),
                   MakeObject(torus, 1.2, 0.07, 5.1, 0.6, 0.3, 0xFFE0C040),
                   MakeObject(torus, -3.1, 0.91, 10.3, 1.4, 0.1, 0xFF70B070),
                   MakeObject(harness::Cube(), 0.6, -0.4, 12.7, 2.1, 0.4, 0xFF9060A0)};
  scene.planes = {{0, 1, 0, -0.05}};
  if (plane_count == 3) {
    scene.planes.push_back({0.93, 0.11, -0.21, 2.9});
    scene.planes.push_back({-0.21, -0.87, 0.13, -0.25});
  }
  const Matrix view = harness::LookAt({0.3, 2.3, -0.4}, {0.1, 0.2, 7});
  scene.view = Multiply(runtime::MirrorMatrix(scene.planes[0]).value, view);
  scene.projection = harness::Perspective(0.85, 1, 0.5, 60);
  return scene;
}

Skin SkinOf(const Matrix& matrix) {
  Skin skin = {{}, {1, 0, 0, 0}, {0.5F, 0.25F, 0, 0}, {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      skin.bones[1].m[row][column] = row < 3 ? 2 * matrix.m[row][column] : 0;
      skin.bones[0].m[row][column] = row < 3 ? 0 : 4 * matrix.m[row][column];
    }
  }
  return skin;
}

const char* NameOf(Mistake mistake) {
  constexpr const char* kNames[] = {"none", "index", "sign", "space", "mask", "offset"};
  return kNames[static_cast<int>(mistake)];
}

std::array<runtime::Float4, 3> PlaneConstants(const Scene& scene, const Matrix& projection,
                                              double scale, Mistake mistake) {
  std::array<runtime::Float4, 3> constants;
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    Plane plane = runtime::ViewPlaneFromWorld(scene.planes[i], scene.view).value.plane;
    const double factor = mistake == Mistake::kSign && i == 0 ? -scale : scale;
    plane = {factor * plane.x, factor * plane.y, factor * plane.z, factor * plane.w};
    const auto constant = runtime::ClipPlaneFromView(plane, projection);
    if (!constant.ok()) std::abort();
    constants[i] = constant.value.constant;
    // A likely mistake (seed 000): the plane as the application has it, not in clip space.
    if (mistake == Mistake::kSpace && i == 0)
      constants[i] = runtime::RoundPlane(scene.planes[i]).value;
  }
  // Another plane has the index of the first, which has none.
  if (mistake == Mistake::kIndex) constants[0] = constants[1];
  return constants;
}

runtime::Table MistakenTable(runtime::Table table, Mistake mistake) {
  if (mistake == Mistake::kMask) table.enable_mask &= ~1U;
  if (mistake == Mistake::kOffset) table.planes.at(0).byte_offset = table.planes.at(1).byte_offset;
  return table;
}

}  // namespace clipc::scenes
