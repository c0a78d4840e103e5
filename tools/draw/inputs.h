// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <epoxy/gl.h>

#include "backend-glsl/write.h"
#include "tools/harness/offscreen.h"

// The inputs and outputs of a vertex shader, on OpenGL as on Vulkan.
namespace clipc::draw {

using glsl::GlslInfo;
using harness::DrawError;

using Words = std::vector<std::uint32_t>;  // the bits of floats, ints or uints
using Bytes = std::vector<std::uint8_t>;

// Bytes as words, without a remainder of fewer than four bytes, and words as bytes, as they lie in
// memory.
inline Words WordsOf(std::span<const std::uint8_t> bytes) {
  Words words(bytes.size() / 4);
  if (!words.empty()) std::memcpy(words.data(), bytes.data(), 4 * words.size());
  return words;
}
inline Bytes BytesOf(std::span<const std::uint32_t> words) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(words.data());
  return {bytes, bytes + 4 * words.size()};
}

// The samples of a pixel of a multisampled texture.
inline constexpr std::uint32_t kSamples = 4;

enum class WordKind { kFloat, kInt, kUint };

// The words of a GLSL type.
struct WordLayout {
  WordKind kind = WordKind::kFloat;
  int columns = 1;  // of a matrix; 1 for every other type
  int rows = 1;     // components of a vector or of a matrix's column
  int Words() const { return columns * rows; }
};

// The values that a vertex shader reads. Words are of the type that the shader declares. Inputs
// that the shader does not use are ignored; using an input that is not here is a DrawError.
struct Inputs {
  struct Attribute {
    std::string name;
    Words words;  // of vertex 0, then of vertex 1, ...
  };
  struct UniformBlock {
    std::string name;  // "B[1]" for an element of an array of blocks
    Bytes bytes;       // as the block lies in memory; zeros follow them
  };
  struct Uniform {
    std::string name;  // "planes[0]" for an array
    Words words;       // matrices column by column
  };
  struct Texture {
    struct Level {
      // The size as glTexImage3D needs it: six layers for each cube of an array; of multisampled
      // ones the layers for each sample, whose texels come one after another.
      std::array<std::uint32_t, 3> size{1, 1, 1};
      Words words;  // `components` for each texel, one where `compares` is set
    };
    std::string name;   // of the sampler variable; "maps[1]" for an element of an array
    GLenum target = 0;  // GL_TEXTURE_BUFFER: the words of the only level are the buffer
    WordKind kind = WordKind::kFloat;
    bool compares = false;  // a depth texture: a reference passes that is less or equal
    bool is_image = false;  // what shaders can write: it has one level
    int components = 4;     // of a texel; 1, 2 or 4 of an image
    std::vector<Level> levels;
  };
  struct Storage {
    std::string name;  // of the buffer; "items[1]" for an element of an array
    std::uint32_t binding;
    Bytes bytes;
  };
  int vertices = 0;
  int instances = 1;
  // The start of the draw call. OpenGL ES supports 0 alone.
  int first_vertex = 0, base_instance = 0;
  std::vector<Attribute> attributes;
  std::vector<UniformBlock> blocks;
  std::vector<Uniform> uniforms;
  std::vector<Texture> textures;
  std::vector<Storage> storage;  // the storage blocks
  // Called with OpenGL's name of each uniform that the linked shader reads; returns its words, or
  // nothing where `uniforms` has it. OpenGL leaves out the uniforms that no output depends on.
  std::function<Words(const std::string& name)> find_uniform;
};

// The values of one output that transform feedback captured.
struct Captured {
  std::string name;
  WordLayout layout;  // of one element
  int count = 1;      // elements of an array
  Words words;        // of vertex 0, then of vertex 1, ...; instance by instance
};

}  // namespace clipc::draw
