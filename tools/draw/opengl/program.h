// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/not_copied.h"
#include "tools/draw/inputs.h"
#include "tools/harness/drawing.h"

namespace clipc::draw {

// The first line of a shader.
struct Version {
  int number = 110;
  bool es = false;
  harness::Api api = harness::Api::kCompatibility;  // of a context that compiles the shader

  std::string Line() const;
  // The line, and the extensions that stages with several vertices need.
  std::string Head() const;
};
Version VersionOf(const std::string& glsl);

// One attribute or uniform of a linked shader.
struct Active {
  std::string name;  // "planes[0]" for an array
  GLenum type = 0;
  int count = 1;  // elements of an array
  int location = -1;
};
// Returns the layout of an OpenGL type, for bools that of uints; none for doubles and samplers.
std::optional<WordLayout> FindLayout(GLenum type);
// Returns the layout of the variable's type. Throws DrawError where FindLayout returns none.
WordLayout LayoutOf(const Active& active);

struct ActiveBlock {
  std::string name;
  int size = 0;
};

// A member of a uniform block.
struct ActiveMember {
  std::string block;
  GLenum type = 0;
  int offset = 0;  // in bytes
  int count = 1;   // elements of an array
  int stride = 0;  // of an array, in bytes
};

// A linked program with buffers for its inputs, in the context that was current when it was made.
class GlProgram : NotCopied {
 public:
  // Links the shaders; `fragment` may be empty where the API allows a program without one.
  // `captured` are the outputs for transform feedback; `before_linking` may set up more.
  GlProgram(const std::string& vertex, const std::string& fragment,
            std::span<const std::string> captured,
            const std::function<void(GLuint program)>& before_linking = {});
  // The same of shaders of any stages. The outputs of the last before the fragment shader are
  // captured.
  GlProgram(std::span<const harness::StageText> stages, std::span<const std::string> captured);
  // Links a compute shader.
  explicit GlProgram(const std::string& compute);
  ~GlProgram();

  GLuint id() const { return program_; }
  std::vector<Active> Attributes() const;
  std::vector<Active> Uniforms() const;
  std::vector<ActiveBlock> Blocks() const;
  std::vector<ActiveMember> Members() const;

  // Makes the program current with these inputs.
  void Bind(const Inputs& inputs);

  // An image that was bound.
  struct BoundImage {
    const Inputs::Texture* image;
    GLuint texture;
  };
  const std::vector<BoundImage>& images() const { return images_; }

 private:
  GLuint NewBuffer(GLenum target, const void* data, std::size_t size);
  void BindAttribute(const Active& active, const Inputs& inputs);
  void BindUniform(const Active& active, const Inputs& inputs);
  void BindSampler(const Active& active, const Inputs& inputs);

  GLuint program_;
  GLuint vertex_array_ = 0;
  std::vector<GLuint> buffers_;
  std::vector<GLuint> textures_;  // on texture unit 0, 1, ...
  std::vector<BoundImage> images_;
};

// How a geometry shader runs: after a vertex shader, for primitives of that kind.
struct GeometryRun {
  std::string vertex, geometry;
  GLenum primitive = GL_POINTS;
  int most_vertices = 0;  // that all runs emit together
};
// Runs the geometry shader, which gives points, without a later stage, and returns the outputs
// `names` of all vertices that it emits, in their order.
std::vector<Captured> CaptureGeometry(const GeometryRun& run, std::span<const std::string> names,
                                      const Inputs& inputs);
// Runs the geometry shader as it is, and returns the number of primitives, GL_LINES or
// GL_TRIANGLES, that its strips have. `name` is one of its outputs.
std::size_t CountEmitted(const GeometryRun& run, const std::string& name, const Inputs& inputs,
                         GLenum mode);

// How the shaders of patches run: after a vertex shader, for patches of so many vertices.
struct PatchRun {
  std::string vertex, control, evaluation;
  int patch_vertices = 1;
  int most_points = 0;  // that the tessellator makes of all patches together
};
// Runs the shaders, of which the last gives points, without a later stage, and returns its outputs
// `names` for all points, in their order.
std::vector<Captured> CapturePatches(const PatchRun& run, std::span<const std::string> names,
                                     const Inputs& inputs);

// Runs the vertex shader without any other stage, on points, and returns the outputs `names` in
// their order. A context that VersionOf(vertex) names must be current.
std::vector<Captured> Capture(const std::string& vertex, std::span<const std::string> names,
                              const Inputs& inputs);

}  // namespace clipc::draw
