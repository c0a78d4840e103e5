// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/scenes/gl_drawing.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "base/not_copied.h"
#include "runtime/clip_plane.h"
#include "runtime/gl/clip_plane_device.h"
#include "runtime/gl/clip_switches.h"
#include "runtime/level9_binder.h"
#include "runtime/near_plane.h"
#include "runtime/plane_space.h"
#include "scene_clip_distance_1.clip.h"
#include "scene_clip_distance_1.shader.h"
#include "scene_clip_distance_3.clip.h"
#include "scene_clip_distance_3.shader.h"
#include "scene_discard_1.clip.h"
#include "scene_discard_1.shader.h"
#include "scene_discard_3.clip.h"
#include "scene_discard_3.shader.h"
#include "scene_level9_1.clip.h"
#include "scene_level9_1.shader.h"
#include "scene_level9_3.clip.h"
#include "scene_level9_3.shader.h"
#include "scene_near_plane_1.clip.h"
#include "scene_near_plane_1.shader.h"
#include "skinned.clip.h"
#include "skinned.shader.h"
#include "tools/harness/check.h"
#include "tools/harness/drawing.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/offscreen.h"
#include "tools/harness/transform.h"

namespace clipc::scenes {
namespace {

using harness::Canvas;
using harness::Check;
using harness::Floats;
using harness::Image;
using harness::Program;
using runtime::Matrix;
using runtime::Multiply;
using runtime::Plane;

// All shaders draw upside down (--flip-y), so that the first row in memory is the topmost as on
// Direct3D: corners and centers that lie on an edge are then rounded the same way.

const char kFragment[] =
    "#version 130\n"
    "in vec4 vs_COLOR0;\n"
    "out vec4 fragment;\n"
    "void main() { fragment = vs_COLOR0; }\n";

const char kWorldVertex[] =
    "#version 130\n"
    "in vec3 in_POSITION0;\n"
    "in vec4 in_COLOR0;\n"
    "uniform mat4 world;\n"
    "uniform mat4 view_projection;\n"
    "out vec3 world_position;\n"
    "out vec4 color;\n"
    "void main() {\n"
    "  vec4 p = world * vec4(in_POSITION0, 1.0);\n"
    "  world_position = p.xyz;\n"
    "  color = in_COLOR0;\n"
    "  gl_Position = view_projection * p;\n"
    "  gl_Position.y = -gl_Position.y;\n"
    "  gl_Position.z = 2.0 * gl_Position.z - gl_Position.w;\n"
    "}\n";
const char kKeptFragment[] =
    "#version 130\n"
    "in vec3 world_position;\n"
    "in vec4 color;\n"
    "uniform vec4 plane0, plane1, plane2, any_plane;\n"
    "out vec4 fragment;\n"
    "void main() {\n"
    "  vec4 p = vec4(world_position, 1.0);\n"
    "  bvec3 kept = greaterThanEqual(vec3(dot(p, plane0), dot(p, plane1), dot(p, plane2)), "
    "vec3(0.0));\n"
    "  if (!(any_plane.x > 0.0 ? any(kept) : all(kept))) discard;\n"
    "  fragment = color;\n"
    "}\n";
// d is linear over a surface, so d over the length of its slope is the distance to d = 0 in pixels.
const char kCutsFragment[] =
    "#version 130\n"
    "in vec3 world_position;\n"
    "uniform vec4 plane0, plane1, plane2;\n"
    "out vec4 fragment;\n"
    "float pixels(vec4 plane) {\n"
    "  float d = dot(vec4(world_position, 1.0), plane);\n"
    "  return d / max(length(vec2(dFdx(d), dFdy(d))), 1e-20);\n"
    "}\n"
    "void main() {\n"
    "  vec3 d = vec3(pixels(plane0), pixels(plane1), pixels(plane2));\n"
    "  if (any(lessThan(d, vec3(-1.0))) || !any(lessThan(abs(d), vec3(1.0)))) discard;\n"
    "  fragment = vec4(1.0);\n"
    "}\n";

struct Shader {
  const char* vertex;
  const char* fragment;
  const StaticClipTable* table;
};

Shader ShaderOf(Lowering lowering, std::size_t plane_count) {
  const bool one = plane_count == 1;
  switch (lowering) {
    case Lowering::kClipDistance:
      return one ? Shader{scene_clip_distance_1_vert, kFragment, &scene_clip_distance_1_clip_table}
                 : Shader{scene_clip_distance_3_vert, kFragment, &scene_clip_distance_3_clip_table};
    case Lowering::kLevel9:
      return one ? Shader{scene_level9_1_vert, kFragment, &scene_level9_1_clip_table}
                 : Shader{scene_level9_3_vert, kFragment, &scene_level9_3_clip_table};
    case Lowering::kDiscard:
      return one ? Shader{scene_discard_1_vert, scene_discard_1_frag, &scene_discard_1_clip_table}
                 : Shader{scene_discard_3_vert, scene_discard_3_frag, &scene_discard_3_clip_table};
    case Lowering::kNearPlane:
      if (one) return {scene_near_plane_1_vert, kFragment, &scene_near_plane_1_clip_table};
      break;
    case Lowering::kNone: break;
  }
  throw std::runtime_error("no such shader");
}

// Direct3D 9 has pixel centers at integers, OpenGL half a pixel beside: to the right and down.
constexpr double kOffset = 1.0 / kSize;

// The projection with the offset that the shader adds for that, so that planes cut where they do on
// Direct3D 9, which moves the image after clipping.
Matrix MovedProjection(const Scene& scene) {
  Matrix move;
  move.m[3][0] = kOffset;
  move.m[3][1] = -kOffset;
  // w takes the place of 1: a shear of clip space.
  return Multiply(scene.projection, move);
}

// Triangles of one object, drawn once.
class ObjectBuffers : NotCopied {
 public:
  explicit ObjectBuffers(const Object& object)
      : count_(static_cast<GLsizei>(object.vertices.size())) {
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    buffer_ = harness::NewBuffer(GL_ARRAY_BUFFER, object.vertices.data(),
                                 object.vertices.size() * sizeof(SceneVertex));
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(SceneVertex), nullptr);
    // A D3DCOLOR is blue, green, red, alpha.
    glVertexAttribPointer(1, GL_BGRA, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(SceneVertex),
                          // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL's way to say it
                          reinterpret_cast<void*>(offsetof(SceneVertex, color)));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
  }
  ~ObjectBuffers() {
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(1, &buffer_);
  }

  void Draw() const { glDrawArrays(GL_TRIANGLES, 0, count_); }

 private:
  GLsizei count_;
  GLuint array_ = 0, buffer_ = 0;
};

using SetMatrix = void(const Program& program, const Matrix& world_view_projection);

void SetOneMatrix(const Program& program, const Matrix& world_view_projection) {
  program.Set("world_view_projection", Floats(world_view_projection));
}

void SetSkin(const Program& program, const Matrix& world_view_projection) {
  const Skin skin = SkinOf(world_view_projection);
  const auto set = [&](const std::string& name, const runtime::Float4& value) {
    program.Set(name, value.x, value.y, value.z, value.w);
  };
  for (std::size_t i = 0; i < skin.bones.size(); ++i)
    program.Set("bones[" + std::to_string(i) + "]", Floats(skin.bones[i]));
  for (std::size_t i = 0; i < skin.lights.size(); ++i)
    set("lights[" + std::to_string(i) + "]", skin.lights[i]);
  set("indices", skin.indices);
  set("weights", skin.weights);
}

void DrawObjects(const Program& program, const Scene& scene, SetMatrix& set_matrix) {
  program.Set("pixel_offset", static_cast<float>(kOffset), static_cast<float>(-kOffset), 0, 0);
  for (const Object& object : scene.objects) {
    set_matrix(program, Multiply(Multiply(object.world, scene.view), scene.projection));
    ObjectBuffers(object).Draw();
  }
}

// Draws the objects with a program of kWorldVertex; `missing` is used for planes that the scene
// does not have.
void DrawInWorld(const Program& program, const Scene& scene, const Plane& missing) {
  program.Set("view_projection", Floats(Multiply(scene.view, MovedProjection(scene))));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [x, y, z, w] =
        runtime::RoundPlane(i < scene.planes.size() ? scene.planes[i] : missing).value;
    program.Set("plane" + std::to_string(i), x, y, z, w);
  }
  for (const Object& object : scene.objects) {
    program.Set("world", Floats(object.world));
    ObjectBuffers(object).Draw();
  }
}

void Clear() {
  glClearColor(0x20 / 255.0F, 0x30 / 255.0F, 0x40 / 255.0F, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

double NearPlaneScaleOf(const Scene& scene) {
  const Plane plane = Check(runtime::ViewPlaneFromWorld(scene.planes[0], scene.view)).plane;
  return Check(runtime::ShearNearPlane(plane, MovedProjection(scene), {},
                                       runtime::NearPlaneScale::kKeepFar))
      .scale;
}

Image DrawWith(const Shader& shader, const Scene& scene, Mistake mistake, SetMatrix& set_matrix) {
  const runtime::gl::Functions gl = Check(runtime::gl::LoadFunctions(harness::OpenGl::Load));
  const runtime::Table table = MistakenTable(Check(runtime::ReadTable(*shader.table)), mistake);
  const double scale = table.lowering == Lowering::kNearPlane ? NearPlaneScaleOf(scene) : 1;
  const auto planes = PlaneConstants(scene, MovedProjection(scene), scale, mistake);

  const Canvas canvas(kSize, kSize);
  Clear();
  const Program program(shader.vertex, shader.fragment, {"in_POSITION0", "in_COLOR0"});
  program.Use();
  if (table.lowering == Lowering::kLevel9) {
    runtime::gl::ClipPlaneDevice device(gl);
    runtime::Level9Binder binder(device, device.max_planes());
    const runtime::BoundBuffer buffer{1, 0, planes.data(), sizeof planes};
    Check(binder.Bind(table, &buffer, 1));
    DrawObjects(program, scene, set_matrix);
  } else {
    runtime::gl::ClipSwitches switches(gl);
    Check(switches.Bind(table));
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const auto [x, y, z, w] = planes[i];
      program.Set("planes[" + std::to_string(i) + "]", x, y, z, w);
    }
    DrawObjects(program, scene, set_matrix);
  }
  return canvas.ReadUpsideDown();
}

}  // namespace

Image DrawScene(Lowering lowering, const Scene& scene, Mistake mistake) {
  return DrawWith(ShaderOf(lowering, scene.planes.size()), scene, mistake, SetOneMatrix);
}

Image DrawSkinned(const Scene& scene) {
  return DrawWith({skinned_vert, kFragment, &skinned_clip_table}, scene, Mistake::kNone, SetSkin);
}

Image DrawKept(const Scene& scene, Kept kept) {
  const Canvas canvas(kSize, kSize);
  Clear();
  const Program program(kWorldVertex, kKeptFragment, {"in_POSITION0", "in_COLOR0"});
  program.Use();
  const bool any = kept == Kept::kByAny;
  program.Set("any_plane", any ? 1 : 0, 0, 0, 0);
  // A missing plane keeps nothing under kByAny, and everything under kByAll.
  DrawInWorld(program, scene, {0, 0, 0, any ? -1.0 : 1.0});
  return canvas.ReadUpsideDown();
}

Image DrawCuts(const Scene& scene) {
  const Canvas canvas(kSize, kSize);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  const Program program(kWorldVertex, kCutsFragment, {"in_POSITION0"});
  program.Use();
  // A missing plane keeps everything, and is far from everything.
  DrawInWorld(program, scene, {0, 0, 0, 1});
  glEnable(GL_DEPTH_TEST);
  return canvas.ReadUpsideDown();
}

double CutError(const Scene& scene) {
  double worst = 0;
  for (const Plane& plane : scene.planes) {
    const Plane in_view = Check(runtime::ViewPlaneFromWorld(plane, scene.view)).plane;
    worst = std::max(worst, Check(runtime::PredictEdgeError(PlaneSpace::kClip, in_view,
                                                            scene.projection, kSize)));
  }
  return worst;
}

}  // namespace clipc::scenes
