// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A lake on OpenGL 4.5, as docs/lake.md explains it: a shadow map, the image in the water, and the
// screen.
//   lake [FILE.png]
#include <cstdio>
#include <deque>
#include <exception>
#include <string>
#include <vector>

#include <clipc/runtime/gl/clip_switches.h>
#include <clipc/runtime/table.h>

#include "depth_to_texture.shader.h"
#include "examples/lake/scene.h"
#include "land.clip.h"
#include "land.shader.h"
#include "land_to_texture.shader.h"
#include "surface.clip.h"
#include "surface.shader.h"
#include "tools/harness/drawing.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/offscreen.h"

namespace {

using namespace lake;

// Fills the buffer of the register b0 or b1: the block's binding has the register's number.
void SetBuffer(GLuint binding, const void* bytes, GLsizeiptr size) {
  static GLuint buffers[2];
  if (buffers[binding] == 0) glCreateBuffers(1, &buffers[binding]);
  glNamedBufferData(buffers[binding], size, bytes, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffers[binding]);
}

void Draw(const char* vertex, const char* fragment, const ViewConstants& view,
          const std::vector<Object>& objects, const std::deque<MeshBuffers>& meshes) {
  const GLuint program = LinkProgram(vertex, fragment);
  glUseProgram(program);
  SetBuffer(0, &view, sizeof view);
  for (const Object& object : objects) {
    SetBuffer(1, &object.constants, sizeof object.constants);
    meshes[object.mesh].Draw();
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
  glClearColor(kSky[0], kSky[1], kSky[2], kSky[3]);
  const Scene scene = MakeScene();
  std::deque<MeshBuffers> meshes;
  for (const Mesh& mesh : scene.meshes) meshes.emplace_back(mesh);

  // The shadow map, the texture of t0. SampleCmp compares: the texture says so on OpenGL.
  const GLuint shadow = NewTexture(0, GL_DEPTH_COMPONENT24, kShadow, kShadow);
  glTextureParameteri(shadow, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  BeginPass(0, shadow, kShadow, kShadow);
  Draw(depth_to_texture_vert, "#version 450\nvoid main() {}\n", scene.sunlight, scene.land, meshes);

  // The image in the water, the texture of t1.
  const GLuint mirror = NewTexture(1, GL_RGBA8, kWidth, kHeight);
  const GLuint mirror_depth = NewTexture(2, GL_DEPTH_COMPONENT24, kWidth, kHeight);
  const auto table = Check(runtime::ReadTable(land_clip_table));
  runtime::gl::ClipSwitches switches(Check(runtime::gl::LoadFunctions(OpenGl::Load)));
  BeginPass(mirror, mirror_depth, kWidth, kHeight);
  Check(switches.Bind(table));  // enables the distances that the shader writes
  Draw(land_to_texture_vert, land_to_texture_frag, scene.mirrored, scene.land, meshes);

  // The screen.
  const Canvas screen(kWidth, kHeight);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  Draw(land_vert, land_frag, scene.seen, scene.land, meshes);
  Check(switches.Bind(Check(runtime::ReadTable(surface_clip_table))));  // it writes none
  Draw(surface_vert, surface_frag, scene.seen, scene.surface, meshes);
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
