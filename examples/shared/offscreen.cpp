// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "examples/shared/offscreen.h"

#include <cstring>
#include <stdexcept>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <png.h>

namespace clipc::examples {
namespace {

GLuint Compile(GLenum stage, const char* text) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok != 0) return shader;
  char log[2048] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  throw std::runtime_error(std::string(log) + text);
}

}  // namespace

Context::Context(Profile profile) {
  const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_display == nullptr) throw std::runtime_error("EGL has no platforms");
  display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (!eglInitialize(display_, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) {
    throw std::runtime_error("EGL has no surfaceless platform with OpenGL");
  }
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               4,
                               EGL_CONTEXT_MINOR_VERSION,
                               5,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               profile == Profile::kCore
                                   ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                                   : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                               EGL_NONE};
  context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (context_ == EGL_NO_CONTEXT ||
      !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
    throw std::runtime_error("no OpenGL 4.5 context");
  }
}

Context::~Context() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

runtime::gl::Procedure Context::Load(const char* name) { return eglGetProcAddress(name); }

Picture Half(const Picture& picture) {
  Picture half{picture.width / 2, picture.height / 2, {}};
  const auto at = [&](int x, int y, int channel) {
    return picture.rgba[static_cast<std::size_t>(4 * (y * picture.width + x) + channel)];
  };
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (int c = 0; c < 4; ++c) {
        const int sum = at(2 * x, 2 * y, c) + at(2 * x + 1, 2 * y, c) + at(2 * x, 2 * y + 1, c) +
                        at(2 * x + 1, 2 * y + 1, c);
        half.rgba.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      }
    }
  }
  return half;
}

void WritePng(const std::string& path, const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> rgb;
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    if (i % 4 != 3) rgb.push_back(picture.rgba[i]);
  }
  if (png_image_write_to_file(&image, path.c_str(), 0, rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error("cannot write " + path);
  }
}

Canvas::Canvas(int width, int height) : width_(width), height_(height) {
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glGenRenderbuffers(1, &color_);
  glBindRenderbuffer(GL_RENDERBUFFER, color_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
  glGenRenderbuffers(1, &depth_);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("no framebuffer");
  glViewport(0, 0, width, height);
  glEnable(GL_DEPTH_TEST);
}

Canvas::~Canvas() {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteRenderbuffers(1, &color_);
  glDeleteRenderbuffers(1, &depth_);
}

Picture Canvas::Read() const {
  const std::size_t row = 4 * static_cast<std::size_t>(width_),
                    rows = static_cast<std::size_t>(height_);
  std::vector<std::uint8_t> upwards(row * rows);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, upwards.data());
  if (glGetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL noted an error");
  Picture picture{width_, height_, std::vector<std::uint8_t>(row * rows)};
  for (std::size_t y = 0; y < rows; ++y)
    std::memcpy(&picture.rgba[y * row], &upwards[(rows - 1 - y) * row], row);
  return picture;
}

Program::Program(const char* vertex, const char* fragment,
                 std::initializer_list<const char*> inputs)
    : program_(glCreateProgram()) {
  for (const GLuint shader :
       {Compile(GL_VERTEX_SHADER, vertex), Compile(GL_FRAGMENT_SHADER, fragment)}) {
    glAttachShader(program_, shader);
    glDeleteShader(shader);
  }
  GLuint attribute = 0;
  for (const char* input : inputs) glBindAttribLocation(program_, attribute++, input);
  glLinkProgram(program_);
  GLint ok = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &ok);
  if (ok != 0) return;
  char log[2048] = "";
  glGetProgramInfoLog(program_, sizeof log, nullptr, log);
  throw std::runtime_error(log);
}

void Program::Set(const char* name, const std::array<float, 16>& matrix) const {
  glUniformMatrix4fv(glGetUniformLocation(program_, name), 1, GL_FALSE, matrix.data());
}

void Program::Set(const char* name, float x, float y, float z, float w) const {
  glUniform4f(glGetUniformLocation(program_, name), x, y, z, w);
}

void Program::BindBlock(const char* name, GLuint slot) const {
  if (const GLuint block = glGetUniformBlockIndex(program_, name); block != GL_INVALID_INDEX) {
    glUniformBlockBinding(program_, block, slot);
  }
}

MeshBuffers::MeshBuffers(const Mesh& mesh) : count_(static_cast<GLsizei>(mesh.indices.size())) {
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glGenBuffers(1, &vertices_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)),
               mesh.vertices.data(), GL_STATIC_DRAW);
  glGenBuffers(1, &indices_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
               mesh.indices.data(), GL_STATIC_DRAW);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                        reinterpret_cast<void*>(offsetof(Vertex, normal)));
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(1);
}

MeshBuffers::~MeshBuffers() {
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &vertices_);
  glDeleteBuffers(1, &indices_);
}

void MeshBuffers::Draw() const {
  glBindVertexArray(array_);
  glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace clipc::examples
