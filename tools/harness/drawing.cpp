// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/harness/drawing.h"

#include <algorithm>
#include <cstddef>

#include "tools/harness/offscreen.h"

namespace clipc::harness {

namespace {

struct Stage {
  GLenum stage;
  const char* name;  // in messages
};
constexpr Stage kStages[] = {{GL_VERTEX_SHADER, "vertex"},
                             {GL_TESS_CONTROL_SHADER, "tessellation control"},
                             {GL_TESS_EVALUATION_SHADER, "tessellation evaluation"},
                             {GL_GEOMETRY_SHADER, "geometry"},
                             {GL_FRAGMENT_SHADER, "fragment"},
                             {GL_COMPUTE_SHADER, "compute"}};

}  // namespace

GLuint LinkStages(std::span<const StageText> shaders,
                  const std::function<void(GLuint program)>& before_linking) {
  const GLuint program = glCreateProgram();
  GLint ok = 0;
  char log[4096] = "";
  for (const auto& [stage, source] : shaders) {
    if (source.empty()) continue;
    const GLuint shader = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    if (!ok)
      throw DrawError(std::string("OpenGL refuses the ") +
                      std::ranges::find(kStages, stage, &Stage::stage)->name + " shader:\n" + log +
                      "\n" + source);
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  if (before_linking) before_linking(program);
  glLinkProgram(program);
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  glGetProgramInfoLog(program, sizeof log, nullptr, log);
  if (!ok) throw DrawError(std::string("OpenGL cannot link the shader:\n") + log);
  return program;
}

GLuint LinkProgram(const std::string& vertex, const std::string& fragment,
                   const std::function<void(GLuint program)>& before_linking) {
  const StageText stages[] = {{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}};
  return LinkStages(stages, before_linking);
}

GLuint LinkComputeProgram(const std::string& compute) {
  const StageText stages[] = {{GL_COMPUTE_SHADER, compute}};
  return LinkStages(stages);
}

GLuint NewBuffer(GLenum target, const void* data, std::size_t bytes) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  return buffer;
}

Program::Program(const std::string& vertex, const std::string& fragment,
                 std::initializer_list<const char*> inputs)
    : program_(LinkProgram(vertex, fragment, [&](GLuint program) {
        GLuint attribute = 0;
        for (const char* input : inputs) glBindAttribLocation(program, attribute++, input);
      })) {}

void Program::Set(const std::string& name, const std::array<float, 16>& matrix) const {
  glUniformMatrix4fv(glGetUniformLocation(program_, name.c_str()), 1, GL_FALSE, matrix.data());
}

void Program::Set(const std::string& name, float x, float y, float z, float w) const {
  glUniform4f(glGetUniformLocation(program_, name.c_str()), x, y, z, w);
}

MeshBuffers::MeshBuffers(const Mesh& mesh) : count_(static_cast<GLsizei>(mesh.indices.size())) {
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  vertices_ =
      NewBuffer(GL_ARRAY_BUFFER, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
  indices_ = NewBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.data(), 4 * mesh.indices.size());
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

void MeshBuffers::Draw(GLenum mode) const {
  glBindVertexArray(array_);
  glDrawElements(mode, count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace clipc::harness
