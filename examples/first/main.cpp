// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Draws a square that a plane clips, without a display, and writes the image:
//   first FILE.ppm
#define GL_GLEXT_PROTOTYPES
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>
#include <clipc/runtime/gl/clip_switches.h>
#include <clipc/runtime/plane_space.h>
#include <clipc/runtime/table.h>

#include "water.clip.h"
#include "water.shader.h"

namespace {

namespace runtime = clipc::runtime;
constexpr int kSize = 64;

// The bytes of the constant buffers, as Direct3D lays them out. Here the camera is the identity.
constexpr float kFrame[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
constexpr float kSquare[] = {-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0};

[[noreturn]] void Fail(const char* what) {
  std::fprintf(stderr, "first: %s\n", what);
  std::exit(1);
}

void MakeContext() {
  const EGLDisplay display =
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (!eglInitialize(display, nullptr, nullptr)) Fail("no EGL without a display");
  eglBindAPI(EGL_OPENGL_API);
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) Fail("no OpenGL 4.5");
}

void Attach(GLuint program, GLenum stage, const char* text) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
}

GLuint MakeProgram() {
  const GLuint program = glCreateProgram();
  Attach(program, GL_VERTEX_SHADER, water_vert);
  Attach(
      program, GL_FRAGMENT_SHADER,
      "#version 450\nlayout(location = 0) out vec4 colour;\nvoid main() { colour = vec4(1); }\n");
  glLinkProgram(program);
  GLint is_linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
  if (!is_linked) Fail("the program does not link");
  return program;
}

// Makes a buffer at the binding of its register: b0 is 0.
void BindBuffer(GLuint binding, const void* bytes, GLsizeiptr size) {
  GLuint buffer = 0;
  glCreateBuffers(1, &buffer);
  glNamedBufferStorage(buffer, size, bytes, 0);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer);
}

void BindSquare() {
  GLuint buffer = 0, array = 0;
  glCreateBuffers(1, &buffer);
  glNamedBufferStorage(buffer, sizeof kSquare, kSquare, 0);
  glCreateVertexArrays(1, &array);
  glBindVertexArray(array);
  glVertexArrayVertexBuffer(array, 0, buffer, 0, 3 * sizeof(float));
  glVertexArrayAttribFormat(array, 0, 3, GL_FLOAT, GL_FALSE, 0);
  glEnableVertexArrayAttrib(array, 0);
}

void Write(const char* path, const std::vector<unsigned char>& rgb) {
  std::ofstream file(path, std::ios::binary);
  file << "P6\n" << kSize << ' ' << kSize << "\n255\n";
  file.write(reinterpret_cast<const char*>(rgb.data()), static_cast<std::streamsize>(rgb.size()));
  if (!file.flush()) Fail("cannot write the image");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) Fail("usage: first FILE.ppm");
  MakeContext();
  GLuint frame = 0, target = 0;
  glCreateRenderbuffers(1, &target);
  glNamedRenderbufferStorage(target, GL_RGBA8, kSize, kSize);
  glCreateFramebuffers(1, &frame);
  glNamedFramebufferRenderbuffer(frame, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
  glBindFramebuffer(GL_FRAMEBUFFER, frame);
  glViewport(0, 0, kSize, kSize);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);  // depth as Direct3D has it

  // The plane y = 0, of which the upper side is kept, given in the world.
  const auto table = runtime::ReadTable(water_clip_table);
  const runtime::Matrix identity = runtime::RowVectorMatrix(kFrame);
  const auto plane =
      runtime::PlaneConstantFor(table.value.plane_space, {0, 1, 0, 0}, runtime::KnownIn::kWorld,
                                {identity, identity, identity}, {kSize});
  if (!table.ok()) Fail(table.status.message());
  if (!plane.ok()) Fail(plane.status.message());

  glUseProgram(MakeProgram());
  BindBuffer(0, kFrame, sizeof kFrame);
  BindBuffer(table.value.planes[0].register_number, &plane.value.plane.constant, 16);
  BindSquare();
  const auto gl = runtime::gl::LoadFunctions(eglGetProcAddress);
  runtime::gl::ClipSwitches switches(gl.value);
  if (const auto status = switches.Bind(table.value); !status.ok()) Fail(status.message());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);

  std::vector<unsigned char> rgb(std::size_t{3} * kSize * kSize);
  glReadPixels(0, 0, kSize, kSize, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
  Write(argv[1], rgb);
  int lower = 0, upper = 0;
  for (std::size_t i = 0; i < rgb.size(); i += 3)
    (i < rgb.size() / 2 ? lower : upper) += rgb[i] == 255 ? 1 : 0;
  std::printf("%d pixels above the plane, %d below it\n", upper, lower);
  return upper == kSize * kSize / 2 && lower == 0 ? 0 : 1;
}
