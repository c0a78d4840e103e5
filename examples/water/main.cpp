// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Teapots in a lake, drawn to a PNG once for each of clipc's lowerings: the same reflection,
// clipped at the water by clip distances, by glClipPlane as Direct3D 9's SetClipPlane would do it,
// by the near plane, and by discard. A fifth image is not clipped and shows what would go wrong:
// the mirrored bottoms stick out of the water.
//   water [FOLDER]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <clipc/runtime/clip_plane.h>
#include <clipc/runtime/gl/clip_plane_device.h>
#include <clipc/runtime/gl/clip_switches.h>
#include <clipc/runtime/level9_binder.h>
#include <clipc/runtime/mirror.h>
#include <clipc/runtime/near_plane.h>

#include "fragments.shader.h"
#include "tools/harness/camera.h"
#include "tools/harness/check.h"
#include "tools/harness/drawing.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/offscreen.h"
#include "water_clip_distance.clip.h"
#include "water_clip_distance.shader.h"
#include "water_discard.clip.h"
#include "water_discard.shader.h"
#include "water_level9.clip.h"
#include "water_level9.shader.h"
#include "water_near_plane.clip.h"
#include "water_near_plane.shader.h"
#include "water_none.clip.h"
#include "water_none.shader.h"

namespace {

using namespace clipc::harness;
namespace runtime = clipc::runtime;

// The plane that keeps the points above the water, y >= 0.
constexpr runtime::Plane kWater{0, 1, 0, 0};

constexpr Vector kEye{0, 2.0, -1.5}, kTarget{0, 0.2, 6};
constexpr int kWidth = 480, kHeight = 300;

struct Object {
  const MeshBuffers* mesh;
  Matrix world;
  float red, green, blue;
};

// Draws all objects. `eye_height` is negative for a mirrored eye.
void DrawObjects(const Program& program, const std::vector<Object>& objects, const Matrix& view,
                 const Matrix& projection, double eye_height) {
  program.Set("eye", static_cast<float>(kEye.x), static_cast<float>(eye_height),
              static_cast<float>(kEye.z), 1);
  for (const Object& object : objects) {
    program.Set("world_view_projection",
                Floats(Multiply(Multiply(object.world, view), projection)));
    program.Set("world", Floats(object.world));
    program.Set("color", object.red, object.green, object.blue, 1);
    object.mesh->Draw();
  }
}

// The water's surface in clip space as a shader of this lowering wants it.
runtime::Float4 PlaneFor(runtime::Lowering lowering, const Matrix& view, const Matrix& projection) {
  runtime::Plane plane = Check(runtime::ViewPlaneFromWorld(kWater, view)).plane;
  if (lowering == runtime::Lowering::kNearPlane) {
    // Here the plane becomes depth, so its length counts: this one loses nothing at the far plane.
    const double a =
        Check(runtime::ShearNearPlane(plane, projection, {}, runtime::NearPlaneScale::kKeepFar))
            .scale;
    plane = {a * plane.x, a * plane.y, a * plane.z, a * plane.w};
  }
  return Check(runtime::ClipPlaneFromView(plane, projection)).constant;
}

struct Technique {
  const char* name;
  const char* vertex;
  const char* fragment;
  const clipc::StaticClipTable* table;
};

class Lake {
 public:
  Lake()
      : plain_(water_none_vert, water_fragment),
        water_(water_none_vert, surface_fragment),
        teapot_(Teapot(24)),
        torus_(Torus(24, 1.3, 0.3)),
        surface_(Ground(400, 1)) {
    const auto place = [](double x, double y, double z, double size, double angle) {
      return Multiply(Multiply(Scaling(size), Rotation(angle)), Translation(x, y, z));
    };
    objects_ = {{&teapot_, place(-1.4, 0.3, 5.5, 1.1, 0.5), 0.80F, 0.45F, 0.25F},
                {&teapot_, place(2.2, 0.9, 8.5, 1.4, 2.6), 0.35F, 0.55F, 0.85F},
                {&torus_, place(0.9, 0.0, 4.2, 0.5, 0.0), 0.85F, 0.75F, 0.30F},
                {&teapot_, place(-4.2, -0.9, 11, 1.6, -0.7), 0.55F, 0.75F, 0.45F}};
  }

  Image Draw(const Technique& technique) const {
    const Canvas canvas(2 * kWidth, 2 * kHeight);
    DrawSky();
    glClear(GL_DEPTH_BUFFER_BIT);
    DrawReflection(technique);
    glClear(GL_DEPTH_BUFFER_BIT);
    DrawSurface();
    plain_.Use();
    DrawObjects(plain_, objects_, view_, projection_, kEye.y);
    return Half(canvas.Read());
  }

 private:
  void DrawReflection(const Technique& technique) const {
    const runtime::gl::Functions gl = Check(runtime::gl::LoadFunctions(OpenGl::Load));
    const runtime::Table table = Check(runtime::ReadTable(*technique.table));
    const Matrix mirrored = Multiply(Check(runtime::MirrorMatrix(kWater)), view_);
    const runtime::Float4 plane = PlaneFor(table.lowering, mirrored, projection_);
    const Program program(technique.vertex, technique.fragment);
    program.Use();
    if (table.lowering == runtime::Lowering::kLevel9) {
      // The device clips: the binder reads the plane from the constants as the table says, and sets
      // it.
      runtime::gl::ClipPlaneDevice device(gl);
      runtime::Level9Binder binder(device, device.max_planes());
      const runtime::BoundBuffer scene{table.planes[0].register_number, 0, &plane, sizeof plane};
      Check(binder.Bind(table, &scene, 1));
      DrawObjects(program, objects_, mirrored, projection_, -kEye.y);
    } else {
      // The shader clips: it gets the plane, and the distances that it writes are enabled.
      runtime::gl::ClipSwitches switches(gl);
      Check(switches.Bind(table));
      program.Set("water_plane", plane.x, plane.y, plane.z, plane.w);
      DrawObjects(program, objects_, mirrored, projection_, -kEye.y);
    }
  }

  // Draws a sky that is brighter towards the horizon, and the same mirrored below it, for the water
  // to reflect.
  void DrawSky() const {
    const Vector ahead = Unit({kTarget.x - kEye.x, 0, kTarget.z - kEye.z});
    const double up = Dot({view_.m[0][1], 0, view_.m[2][1]}, ahead),
                 depth = Dot({view_.m[0][2], 0, view_.m[2][2]}, ahead);
    const double horizon = kHeight * (1 + projection_.m[1][1] * up / depth);
    glEnable(GL_SCISSOR_TEST);
    for (int row = 0; row < 2 * kHeight; ++row) {
      const auto height = static_cast<float>(std::min(1.0, std::abs(row - horizon) / kHeight));
      glScissor(0, row, 2 * kWidth, 1);
      glClearColor(0.88F - 0.50F * height, 0.93F - 0.32F * height, 0.97F - 0.12F * height, 1);
      glClear(GL_COLOR_BUFFER_BIT);
    }
    glDisable(GL_SCISSOR_TEST);
  }

  void DrawSurface() const {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    water_.Use();
    DrawObjects(water_, {{&surface_, Matrix{}, 0.05F, 0.24F, 0.30F}}, view_, projection_, kEye.y);
    glDisable(GL_BLEND);
  }

  Program plain_, water_;
  MeshBuffers teapot_, torus_, surface_;
  std::vector<Object> objects_;
  Matrix view_ = LookAt(kEye, kTarget);
  Matrix projection_ = Perspective(0.75, static_cast<double>(kWidth) / kHeight, 0.5, 500);
};

}  // namespace

int main(int argc, char** argv) try {
  const std::string folder = argc > 1 ? argv[1] : ".";
  const OpenGl opengl(Api::kCompatibility);
  const Lake lake;
  for (const Technique& technique : {
           Technique{"clip-distance", water_clip_distance_vert, water_fragment,
                     &water_clip_distance_clip_table},
           Technique{"level9", water_level9_vert, water_fragment, &water_level9_clip_table},
           Technique{"near-plane", water_near_plane_vert, water_fragment,
                     &water_near_plane_clip_table},
           Technique{"discard", water_discard_vert, water_discard_frag, &water_discard_clip_table},
           Technique{"none", water_none_vert, water_fragment, &water_none_clip_table},
       }) {
    const std::string path = folder + "/water-" + technique.name + ".png";
    WritePng(path, lake.Draw(technique));
    std::printf("%s\n", path.c_str());
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "water: %s\n", error.what());
  return 1;
}
