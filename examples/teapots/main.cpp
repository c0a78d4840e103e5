// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The teapots of "What Are User-defined Clip Planes?" side by side: whole; clipped by (-1, 0, 0,
// 0), which leaves x <= 0; by (1, 0, 1, 0), which leaves x + z >= 0; and by (1, 0, 0, 0) and (0,
// -1, 0, 0) together, which leaves the part that both keep: x >= 0 and y <= 0. The inside is red.
// Planes are given in world space and set as on Direct3D 9, with glClipPlane for SetClipPlane.
//   teapots [FILE.png]
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <clipc/runtime/clip_plane.h>
#include <clipc/runtime/gl/clip_plane_device.h>
#include <clipc/runtime/level9_binder.h>

#include "fragment.shader.h"
#include "teapots.clip.h"
#include "teapots.shader.h"
#include "tools/harness/camera.h"
#include "tools/harness/check.h"
#include "tools/harness/drawing.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/offscreen.h"

namespace {

using namespace clipc::harness;
namespace runtime = clipc::runtime;

constexpr int kSize = 200;  // of one teapot's part of the image, in pixels
constexpr Vector kEye{-1.9, 2.6, -5.2};

Image DrawTeapots() {
  const std::vector<std::vector<runtime::Plane>> cases = {
      {}, {{-1, 0, 0, 0}}, {{1, 0, 1, 0}}, {{1, 0, 0, 0}, {0, -1, 0, 0}}};
  const int count = static_cast<int>(cases.size());
  const Matrix world, view = LookAt(kEye, {0, 0.1, 0}), projection = Perspective(0.62, 1, 1, 20);
  const runtime::gl::Functions gl = Check(runtime::gl::LoadFunctions(OpenGl::Load));
  const runtime::Table table = Check(runtime::ReadTable(teapots_clip_table));
  runtime::gl::ClipPlaneDevice device(gl);
  runtime::Level9Binder binder(device, device.max_planes());
  const MeshBuffers teapot(Teapot(32));
  const Canvas canvas(2 * count * kSize, 2 * kSize);
  glClearColor(0.93F, 0.94F, 0.96F, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const Program program(teapots_vert, teapots_fragment);
  program.Use();
  program.Set("eye", static_cast<float>(kEye.x), static_cast<float>(kEye.y),
              static_cast<float>(kEye.z), 1);
  program.Set("world", Floats(world));
  program.Set("world_view_projection", Floats(Multiply(Multiply(world, view), projection)));
  for (int i = 0; i < count; ++i) {
    const std::vector<runtime::Plane>& planes = cases[i];
    runtime::Float4 constants[2];
    for (std::size_t k = 0; k < planes.size(); ++k) {
      constants[k] = Check(runtime::ClipPlaneFromWorld(planes[k], view, projection)).constant;
    }
    const runtime::BoundBuffer clip{table.planes[0].register_number, 0, constants,
                                    sizeof constants};
    const std::uint32_t needed = (1U << planes.size()) - 1;
    Check(binder.Bind(table, &clip, 1, needed));
    glViewport(2 * i * kSize, 0, 2 * kSize, 2 * kSize);
    teapot.Draw();
  }
  Check(binder.BindNone());
  return Half(canvas.Read());
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string path = argc > 1 ? argv[1] : "teapots.png";
  const OpenGl opengl(Api::kCompatibility);
  WritePng(path, DrawTeapots());
  std::printf("%s\n", path.c_str());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "teapots: %s\n", error.what());
  return 1;
}
