// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <functional>
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

// The outputs `names` of at most so many points that a draw call gives.
std::vector<Captured> CapturePoints(GlProgram& program, std::size_t names, const Inputs& inputs,
                                    int most, const std::function<void()>& draw) {
  program.Bind(inputs);
  std::vector<Captured> outputs = CapturedOf(program.id(), names);
  std::size_t words = 0;
  for (const Captured& output : outputs)
    words += static_cast<std::size_t>(output.layout.Words()) * output.count;
  const std::size_t bytes = 4 * words * most;

  const GLuint buffer = harness::NewBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, nullptr, bytes);
  GLuint query = 0;
  glGenQueries(1, &query);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query);
  glBeginTransformFeedback(GL_POINTS);
  draw();
  glEndTransformFeedback();
  glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
  glDisable(GL_RASTERIZER_DISCARD);
  GLuint vertices = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &vertices);
  glDeleteQueries(1, &query);
  harness::CheckErrors("running the shader");
  const void* mapped = glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0,
                                        static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT);
  if (!mapped) throw DrawError("reading what transform feedback wrote");
  Distribute(static_cast<const std::uint32_t*>(mapped), static_cast<int>(vertices), outputs);
  glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
  glDeleteBuffers(1, &buffer);
  return outputs;
}

// Captures the outputs, as many at once as fit.
std::vector<Captured> CaptureAll(
    std::span<const std::string> names,
    const std::function<std::vector<Captured>(std::span<const std::string>)>& capture) {
  std::vector<Captured> all;
  while (!names.empty()) {
    std::size_t count = 0;
    for (int components = 0; count < names.size(); ++count) {
      components += MostComponents(names[count]);
      if (components > kMaxComponents) break;
    }
    std::vector<Captured> some = capture(names.first(count));
    std::move(some.begin(), some.end(), std::back_inserter(all));
    names = names.subspan(count);
  }
  return all;
}

std::array<harness::StageText, 3> StagesOf(const GeometryRun& run) {
  return {{{GL_VERTEX_SHADER, run.vertex},
           {GL_GEOMETRY_SHADER, run.geometry},
           {GL_FRAGMENT_SHADER, EmptyFragmentFor(VersionOf(run.geometry))}}};
}

}  // namespace

std::vector<Captured> Capture(const std::string& vertex, std::span<const std::string> names,
                              const Inputs& inputs) {
  const harness::Framebuffer framebuffer(1, 1);
  return CaptureAll(names, [&](std::span<const std::string> some) {
    GlProgram program(vertex, EmptyFragmentFor(VersionOf(vertex)), some);
    return CapturePoints(program, some.size(), inputs, inputs.vertices * inputs.instances,
                         [&] { Draw(inputs); });
  });
}

std::vector<Captured> CaptureGeometry(const GeometryRun& run, std::span<const std::string> names,
                                      const Inputs& inputs) {
  const harness::Framebuffer framebuffer(1, 1);
  return CaptureAll(names, [&](std::span<const std::string> some) {
    GlProgram program(StagesOf(run), some);
    return CapturePoints(program, some.size(), inputs, run.most_vertices,
                         [&] { glDrawArrays(run.primitive, 0, inputs.vertices); });
  });
}

std::vector<Captured> CapturePatches(const PatchRun& run, std::span<const std::string> names,
                                     const Inputs& inputs) {
  const harness::Framebuffer framebuffer(1, 1);
  return CaptureAll(names, [&](std::span<const std::string> some) {
    const harness::StageText stages[] = {
        {GL_VERTEX_SHADER, run.vertex},
        {GL_TESS_CONTROL_SHADER, run.control},
        {GL_TESS_EVALUATION_SHADER, run.evaluation},
        {GL_FRAGMENT_SHADER, EmptyFragmentFor(VersionOf(run.control))}};
    GlProgram program(stages, some);
    return CapturePoints(program, some.size(), inputs, run.most_points, [&] {
      glPatchParameteri(GL_PATCH_VERTICES, run.patch_vertices);
      glDrawArrays(GL_PATCHES, 0, inputs.vertices);
    });
  });
}

std::size_t CountEmitted(const GeometryRun& run, const std::string& name, const Inputs& inputs,
                         GLenum mode) {
  constexpr int kMostWords = 64;  // of the output
  const harness::Framebuffer framebuffer(1, 1);
  const std::string names[] = {name};
  GlProgram program(StagesOf(run), names);
  program.Bind(inputs);
  const std::size_t bytes = std::size_t{4} * kMostWords * 3 * run.most_vertices;
  const GLuint buffer = harness::NewBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, nullptr, bytes);
  GLuint query = 0, primitives = 0;
  glGenQueries(1, &query);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query);
  glBeginTransformFeedback(mode);
  glDrawArrays(run.primitive, 0, inputs.vertices);
  glEndTransformFeedback();
  glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
  glDisable(GL_RASTERIZER_DISCARD);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &primitives);
  glDeleteQueries(1, &query);
  glDeleteBuffers(1, &buffer);
  harness::CheckErrors("counting primitives");
  return primitives;
}

}  // namespace clipc::draw
