// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#define GL_GLEXT_PROTOTYPES 1
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include <GL/glcorearb.h>

#include "examples/shared/mesh.h"
#include "runtime/gl/functions.h"

// OpenGL without a display, as far as the examples need it. What fails throws std::runtime_error.
namespace clipc::examples {

enum class Profile { kCore, kCompatibility };

// OpenGL 4.5 through EGL's surfaceless platform; current until it is destroyed or another one is
// made.
class Context {
 public:
  explicit Context(Profile profile);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // For clipc::runtime::gl::LoadFunctions.
  static runtime::gl::Procedure Load(const char* name);

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

// RGBA, a byte each, rows from top to bottom.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

// Half as wide and as high, each pixel the mean of four: what was drawn too large comes out with
// smooth edges.
Picture Half(const Picture& picture);

void WritePng(const std::string& path, const Picture& picture);

// A color and a depth buffer to draw to; bound, with its viewport set, when made.
class Canvas {
 public:
  Canvas(int width, int height);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  Picture Read() const;

 private:
  int width_, height_;
  GLuint framebuffer_ = 0, color_ = 0, depth_ = 0;
};

// A vertex shader from clipc and a fragment shader. The inputs named get attributes 0, 1 and so on;
// without names as MeshBuffers has them.
class Program {
 public:
  Program(const char* vertex, const char* fragment,
          std::initializer_list<const char*> inputs = {"in_POSITION0", "in_NORMAL0"});
  ~Program() { glDeleteProgram(program_); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void Use() const { glUseProgram(program_); }
  // Plain uniforms of the program in use; a name that the program has not is nothing to set.
  void Set(const char* name, const std::array<float, 16>& matrix) const;
  void Set(const char* name, float x, float y, float z, float w) const;
  // Ties a uniform block to a slot of glBindBufferBase.
  void BindBlock(const char* name, GLuint slot) const;

 private:
  GLuint program_;
};

// A mesh on the device.
class MeshBuffers {
 public:
  explicit MeshBuffers(const Mesh& mesh);
  ~MeshBuffers();
  MeshBuffers(const MeshBuffers&) = delete;
  MeshBuffers& operator=(const MeshBuffers&) = delete;

  void Draw() const;

 private:
  GLsizei count_;
  GLuint array_ = 0, vertices_ = 0, indices_ = 0;
};

}  // namespace clipc::examples
