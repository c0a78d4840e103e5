// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>

#include <epoxy/gl.h>

#include "base/not_copied.h"
#include "tools/harness/mesh.h"

// Shaders and meshes on the current OpenGL context.
namespace clipc::harness {

// A linked program of that vertex shader and that fragment shader, which may be empty for none
// where the API allows it. `before_linking` may set up the program; it may be empty. Throws
// DrawError with OpenGL's log and the shader.
GLuint LinkProgram(const std::string& vertex, const std::string& fragment,
                   const std::function<void(GLuint program)>& before_linking = {});

// The same of shaders of any stages; a text may be empty.
struct StageText {
  GLenum stage = GL_VERTEX_SHADER;
  std::string text;
};
GLuint LinkStages(std::span<const StageText> shaders,
                  const std::function<void(GLuint program)>& before_linking = {});

// The same of a compute shader.
GLuint LinkComputeProgram(const std::string& compute);

// A new buffer of `bytes` bytes, copied from `data` unless that is null. It is bound to `target`.
GLuint NewBuffer(GLenum target, const void* data, std::size_t bytes);

// A vertex shader from clipc and a fragment shader. The named inputs get the attributes 0, 1 and so
// on; the standard ones are as MeshBuffers has them.
class Program : NotCopied {
 public:
  Program(const std::string& vertex, const std::string& fragment,
          std::initializer_list<const char*> inputs = {"in_POSITION0", "in_NORMAL0"});
  ~Program() { glDeleteProgram(program_); }

  GLuint id() const { return program_; }
  void Use() const { glUseProgram(program_); }
  // Sets a plain uniform of the program in use. A name that the program does not have is ignored.
  void Set(const std::string& name, const std::array<float, 16>& matrix) const;
  void Set(const std::string& name, float x, float y, float z, float w) const;

 private:
  GLuint program_;
};

// A mesh on the device.
class MeshBuffers : NotCopied {
 public:
  explicit MeshBuffers(const Mesh& mesh);
  ~MeshBuffers();

  // Draws what the indices name: primitives of that kind.
  void Draw(GLenum mode = GL_TRIANGLES) const;

 private:
  GLsizei count_;
  GLuint array_ = 0, vertices_ = 0, indices_ = 0;
};

}  // namespace clipc::harness
