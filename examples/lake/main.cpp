// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A lake on OpenGL 4.5, as docs/lake.md explains it: a shadow map, the image in the water, and the
// screen.
//   lake [FILE.png]
#include <array>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <clipc/runtime/clip_plane.h>
#include <clipc/runtime/gl/clip_switches.h>
#include <clipc/runtime/mirror.h>
#include <clipc/runtime/table.h>

#include "depth_to_texture.shader.h"
#include "land.clip.h"
#include "land.shader.h"
#include "land_to_texture.shader.h"
#include "surface.clip.h"
#include "surface.shader.h"
#include "tools/harness/camera.h"
#include "tools/harness/check.h"
#include "tools/harness/drawing.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/offscreen.h"

namespace {

using namespace clipc::harness;
namespace runtime = clipc::runtime;

constexpr int kWidth = 960, kHeight = 600, kShadow = 2048;
constexpr runtime::Plane kWater{0, 1, 0, 0};  // keeps y >= 0

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
  const MeshBuffers* mesh;
  ObjectConstants constants;
};

// Fills the buffer of the register b0 or b1: the block's binding has the register's number.
void SetBuffer(GLuint binding, const void* bytes, GLsizeiptr size) {
  static GLuint buffers[2];
  if (buffers[binding] == 0) glCreateBuffers(1, &buffers[binding]);
  glNamedBufferData(buffers[binding], size, bytes, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffers[binding]);
}

void Draw(const char* vertex, const char* fragment, const ViewConstants& view,
          const std::vector<Object>& objects) {
  const GLuint program = LinkProgram(vertex, fragment);
  glUseProgram(program);
  SetBuffer(0, &view, sizeof view);
  for (const Object& object : objects) {
    SetBuffer(1, &object.constants, sizeof object.constants);
    object.mesh->Draw();
  }
  glDeleteProgram(program);
}

// A texture at the unit of its register, t0 or t1, which draws to it get too.
GLuint NewTexture(GLuint unit, GLenum format, int width, int height) {
  GLuint texture = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &texture);
  glTextureStorage2D(texture, 1, format, width, height);
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTextureUnit(unit, texture);
  return texture;
}

void BeginPass(GLuint color, GLuint depth, int width, int height) {
  GLuint framebuffer = 0;
  glCreateFramebuffers(1, &framebuffer);
  if (color != 0) glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, color, 0);
  glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, depth, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Image DrawLake() {
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);  // depth as Direct3D has it
  glEnable(GL_DEPTH_TEST);
  glClearColor(0.62F, 0.78F, 0.92F, 1);
  const MeshBuffers teapot(Teapot(24)), torus(Torus(32, 1.3, 0.3)), shore(Ground(9, 1)),
      lake(Ground(60, 1));
  const auto at = [](double x, double y, double z, double size, double angle) {
    return Floats(Multiply(Multiply(Scaling(size), Rotation(angle)), Translation(x, y, z)));
  };
  const std::vector<Object> land = {{&teapot, {at(-1.2, 0.5, 5, 1, 0.5), {0.9F, 0.5F, 0.3F, 1}}},
                                    {&torus, {at(1.8, 0.1, 5.5, 0.8, 0), {0.9F, 0.8F, 0.3F, 1}}},
                                    {&teapot, {at(2.5, 1.3, 9.5, 1.4, 2.5), {0.4F, 0.6F, 0.9F, 1}}},
                                    {&shore, {at(0, 0.2, 16, 1, 0), {0.55F, 0.62F, 0.35F, 1}}}};
  const Matrix view = LookAt({0, 2, -1}, {0, 0.3, 6});
  const Matrix projection = Perspective(0.75, double{kWidth} / kHeight, 0.5, 200);
  Camera sun;
  sun.orthographic = true, sun.half_height = 18, sun.aspect = 1, sun.near = 1, sun.far = 60;
  const Matrix light = Multiply(LookAt({10, 16, 2}, {0, 0, 10}), sun.Projection());

  // The shadow map, the texture of t0. SampleCmp compares: the texture says so on OpenGL.
  const GLuint shadow = NewTexture(0, GL_DEPTH_COMPONENT24, kShadow, kShadow);
  glTextureParameteri(shadow, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  BeginPass(0, shadow, kShadow, kShadow);
  Draw(depth_to_texture_vert, "#version 450\nvoid main() {}\n", {Floats(light), {}, {}}, land);

  // The image in the water, the texture of t1: the mirrored view of what is above it.
  const GLuint mirror = NewTexture(1, GL_RGBA8, kWidth, kHeight);
  const GLuint mirror_depth = NewTexture(2, GL_DEPTH_COMPONENT24, kWidth, kHeight);
  const Matrix mirrored = Multiply(Check(runtime::MirrorMatrix(kWater)), view);
  const auto water = Check(runtime::ClipPlaneFromWorld(kWater, mirrored, projection));
  const auto table = Check(runtime::ReadTable(land_clip_table));
  runtime::gl::ClipSwitches switches(Check(runtime::gl::LoadFunctions(OpenGl::Load)));
  BeginPass(mirror, mirror_depth, kWidth, kHeight);
  Check(switches.Bind(table));  // enables the distances that the shader writes
  Draw(land_to_texture_vert, land_to_texture_frag,
       {Floats(Multiply(mirrored, projection)), Floats(light), water.constant}, land);

  // The screen. A plane of zeros clips nothing.
  const ViewConstants seen = {Floats(Multiply(view, projection)), Floats(light), {}};
  const Canvas screen(kWidth, kHeight);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  Draw(land_vert, land_frag, seen, land);
  Check(switches.Bind(Check(runtime::ReadTable(surface_clip_table))));  // it writes none
  Draw(surface_vert, surface_frag, seen, {{&lake, {at(0, 0, 0, 1, 0), {0.05F, 0.2F, 0.25F, 1}}}});
  return screen.Read();
}

}  // namespace

int main(int argc, char** argv) try {
  const OpenGl opengl(Api::kCore);
  WritePng(argc > 1 ? argv[1] : "lake.png", Half(DrawLake()));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "lake: %s\n", error.what());
  return 1;
}
