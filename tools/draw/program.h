// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tools/draw/gl.h"

namespace clipc::draw {

// How a GLSL type is made of words.
struct Shape {
  enum class Kind { kFloat, kInt, kUint } kind = Kind::kFloat;
  int columns = 1;  // 1 but for matrices
  int rows = 1;     // components of a vector or of a matrix's column
  int Words() const { return columns * rows; }
};
Shape ShapeOf(GLenum type);  // bool counts as uint; DrawError for double and opaque types

// What a vertex shader reads. Words are the bits of floats, ints or uints, as the shader declares
// them; what the shader has no use for is ignored, what it needs and is not here is a DrawError.
struct Inputs {
  struct Attribute {
    std::string name;
    std::vector<std::uint32_t> words;  // of vertex 0, then of vertex 1, ...
  };
  struct Block {
    std::string name;  // of the uniform block; "B[1]" for an element of an array of blocks
    std::vector<std::uint8_t> bytes;  // as the block lies in memory; zeros behind
  };
  struct Uniform {
    std::string name;                  // "planes[0]" for an array
    std::vector<std::uint32_t> words;  // matrices column by column
  };
  struct Texture {
    struct Level {
      std::array<std::uint32_t, 3> size{
          1, 1, 1};  // as glTexImage3D takes it: six layers for each cube of an array
      std::vector<std::uint32_t> words;  // four for each texel; `compares`: one
    };
    std::string name;   // of the sampler variable; "maps[1]" for an element of an array
    GLenum target = 0;  // GL_TEXTURE_BUFFER: the only level's words are the buffer
    Shape::Kind kind = Shape::Kind::kFloat;
    bool compares = false;  // a depth texture; passes what is less or equal
    std::vector<Level> levels;
  };
  struct Storage {
    std::string name;  // of the buffer; "items[1]" for an element of an array
    std::uint32_t binding;
    std::vector<std::uint8_t> bytes;
  };
  int vertices = 0;
  int instances = 1;
  int first_vertex = 0,
      base_instance = 0;  // of the draw call; not everywhere but in OpenGL's desktop version
  std::vector<Attribute> attributes;
  std::vector<Block> blocks;
  std::vector<Uniform> uniforms;
  std::vector<Texture> textures;
  std::vector<Storage> storage;  // the storage blocks
  // Asked for the uniforms that are not in `uniforms`, by OpenGL's name; empty: it has none of that
  // name. Which uniforms a shader reads is known only when it is linked: what no output needs is
  // not there.
  std::function<std::vector<std::uint32_t>(const std::string& name)> find_uniform;
};

// One attribute or uniform as the linked shader has it.
struct Active {
  std::string name;  // arrays: "planes[0]"
  GLenum type = 0;
  int count = 1;      // elements of an array
  int location = -1;  // -1: in a block
};
struct ActiveBlock {
  std::string name;
  int size = 0;
};

// A linked program with buffers for its inputs. Lives no longer than the context that was current
// when it was made.
class Program {
 public:
  // fragment: empty for none, where the API allows that. captured: outputs for transform feedback.
  Program(const Gl& gl, const std::string& vertex, const std::string& fragment,
          std::span<const std::string> captured);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  GLuint id() const { return program_; }
  std::vector<Active> Attributes() const;
  std::vector<Active> Uniforms() const;
  std::vector<ActiveBlock> Blocks() const;

  // Makes the program current with these inputs.
  void Bind(const Inputs& inputs);

 private:
  void AddShader(GLenum stage, const std::string& source);
  void Link();
  GLuint NewBuffer(GLenum target, const void* data, std::size_t size);
  void BindAttribute(const Active& active, const Inputs& inputs);
  void BindUniform(const Active& active, const Inputs& inputs);
  void BindSampler(const Active& active, const Inputs& inputs);

  const Gl& gl_;
  GLuint program_ = 0;
  GLuint vertex_array_ = 0;
  std::vector<GLuint> buffers_;
  std::vector<GLuint> textures_;  // on texture unit 0, 1, ...
};

// What transform feedback caught of one output.
struct Captured {
  std::string name;
  Shape shape;                       // of one element
  int count = 1;                     // elements of an array
  std::vector<std::uint32_t> words;  // of vertex 0, then of vertex 1, ...; instance by instance
};

// Runs the vertex shader alone, on points, and returns `names` in their order. Optimisers see no
// other stage.
std::vector<Captured> Capture(const Gl& gl, const std::string& vertex,
                              std::span<const std::string> names, const Inputs& inputs);

}  // namespace clipc::draw
