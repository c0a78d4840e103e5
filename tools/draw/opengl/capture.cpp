// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <iterator>
#include <numeric>

#include "tools/draw/opengl/program.h"
#include "tools/harness/drawing.h"
#include "tools/harness/framebuffer.h"

namespace clipc::draw {
namespace {

// Every implementation captures 64 components of a program at once.
constexpr int kMaxComponents = 64;

int MostComponents(const std::string& name) {
  return name == "gl_ClipDistance" || name == "gl_CullDistance" ? 8 : 4;
}

// OpenGL ES does not link a program without a fragment shader.
std::string EmptyFragmentFor(const Version& version) {
  return version.es ? version.Line() + "void main() {}\n" : "";
}

std::vector<Captured> CapturedOf(GLuint program, std::size_t count) {
  std::vector<Captured> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    char name[512] = "";
    Active active;
    glGetTransformFeedbackVarying(program, i, sizeof name, nullptr, &active.count, &active.type,
                                  name);
    active.name = name;
    all[i] = {name, LayoutOf(active), active.count, {}};
  }
  return all;
}

// Appends the captured words, which have vertex after vertex, to the outputs.
void Distribute(const std::uint32_t* words, int vertices, std::vector<Captured>& outputs) {
  for (int vertex = 0; vertex < vertices; ++vertex) {
    for (Captured& output : outputs) {
      const int size = output.layout.Words() * output.count;
      output.words.insert(output.words.end(), words, words + size);
      words += size;
    }
  }
}

// Draws with indices where the draw call does not start at 0: gl_BaseVertex is the base vertex of
// an indexed draw call; glDrawArrays' first vertex counts for gl_VertexID alone.
void Draw(const Inputs& inputs) {
  if (inputs.first_vertex == 0 && inputs.base_instance == 0) {
    return glDrawArraysInstanced(GL_POINTS, 0, inputs.vertices, inputs.instances);
  }
  std::vector<GLuint> indices(inputs.vertices);
  std::iota(indices.begin(), indices.end(), 0u);
  const GLuint buffer =
      harness::NewBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.data(), indices.size() * sizeof(GLuint));
  glDrawElementsInstancedBaseVertexBaseInstance(GL_POINTS, inputs.vertices, GL_UNSIGNED_INT,
                                                nullptr, inputs.instances, inputs.first_vertex,
                                                inputs.base_instance);
  glDeleteBuffers(1, &buffer);
}

std::vector<Captured> CaptureAtOnce(const std::string& vertex, std::span<const std::string> names,
                                    const Inputs& inputs) {
  const harness::Framebuffer framebuffer(1, 1);
  GlProgram program(vertex, EmptyFragmentFor(VersionOf(vertex)), names);
  program.Bind(inputs);
  std::vector<Captured> outputs = CapturedOf(program.id(), names.size());
  std::size_t words = 0;
  for (const Captured& output : outputs)
    words += static_cast<std::size_t>(output.layout.Words()) * output.count;
  const int vertices = inputs.vertices * inputs.instances;
  const std::size_t bytes = 4 * words * vertices;

  const GLuint buffer = harness::NewBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, nullptr, bytes);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  Draw(inputs);
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  harness::CheckErrors("running the vertex shader");
  const void* mapped = glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0,
                                        static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT);
  if (!mapped) throw DrawError("reading what transform feedback wrote");
  Distribute(static_cast<const std::uint32_t*>(mapped), vertices, outputs);
  glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
  glDeleteBuffers(1, &buffer);
  return outputs;
}

}  // namespace

std::vector<Captured> Capture(const std::string& vertex, std::span<const std::string> names,
                              const Inputs& inputs) {
  std::vector<Captured> all;
  while (!names.empty()) {
    std::size_t count = 0;
    for (int components = 0; count < names.size(); ++count) {
      components += MostComponents(names[count]);
      if (components > kMaxComponents) break;
    }
    std::vector<Captured> some = CaptureAtOnce(vertex, names.first(count), inputs);
    std::move(some.begin(), some.end(), std::back_inserter(all));
    names = names.subspan(count);
  }
  return all;
}

}  // namespace clipc::draw
