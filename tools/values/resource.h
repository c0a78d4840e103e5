// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <epoxy/gl.h>

#include "base/not_copied.h"
#include "tools/values/script.h"

// What a [srv], [uav], [rtv], [dsv], [vb] or [sampler] section describes, and its place in OpenGL.
namespace clipc::values {

struct Format {
  std::string_view name;
  GLenum internal = GL_RGBA32F, components = GL_RGBA, type = GL_FLOAT;
  std::uint32_t count = 4;  // components of four bytes
};
// Reads the name of a format. Throws std::runtime_error for another word.
const Format& TakeFormat(Scanner& line);
const Format& FloatFormat();  // r32g32b32a32-float, what is meant where none is given

enum class Role { kTexture, kStorage, kTarget, kDepth, kVertices };
enum class Dimension { kBuffer, k2d, k2dArray, k3d, kCube };

struct ResourceText {
  Role role = Role::kTexture;
  std::uint32_t slot = 0;
  Dimension dimension = Dimension::k2d;
  std::uint32_t width = 640, height = 480, depth = 1;  // depth: layers of an array or a cube too
  std::uint32_t levels = 1, samples = 1;
  Format format;
  std::uint32_t stride = 0;  // of a structured buffer's element
  bool is_raw = false, is_counter = false;
  std::vector<std::uint32_t> words;  // level by level, layer by layer, the top row first

  std::uint32_t TexelSize() const { return stride != 0 ? stride : 4 * format.count; }
};
// The role and the slot of "srv 2". Throws std::runtime_error for another word.
ResourceText TakeReference(Scanner& line);
// Reads the resource of a section. Throws std::runtime_error at a line that the format does not
// have.
ResourceText ReadResource(const Section& section);

struct SamplerText {
  GLenum least = GL_NEAREST_MIPMAP_NEAREST, greatest = GL_NEAREST;  // filters
  std::array<GLenum, 3> wraps = {GL_REPEAT, GL_REPEAT, GL_REPEAT};
  GLenum comparison = GL_NONE;
};
SamplerText ReadSampler(const Section& section);
// "less equal" as OpenGL's name.
GLenum TakeComparison(Scanner& line);

// A resource on the current OpenGL context. The rows of a render target lie from the bottom up, as
// OpenGL draws them; those of all others from the top down, and of multisampled targets, which are
// drawn upside down, as then the samples of a pixel lie as Direct3D's do.
class Resource : NotCopied {
 public:
  explicit Resource(ResourceText text);
  ~Resource();

  const ResourceText& text() const { return text_; }
  GLuint texture() const { return texture_; }  // 0 for structured, raw and vertex buffers
  GLuint buffer() const { return buffer_; }
  GLenum target() const { return target_; }
  bool is_flipped() const {
    return (text_.role == Role::kTarget || text_.role == Role::kDepth) && text_.samples == 1;
  }
  // A texture with the same texels that a comparison sampler can read; made at the first call.
  GLuint DepthTexture();
  // The bytes of level 0, layer by layer, with the top row first.
  std::vector<std::uint8_t> Read() const;
  void CopyFrom(const Resource& other);
  void Clear(const std::array<float, 4>& values) const;

 private:
  GLuint Upload(const Format& format) const;

  ResourceText text_;
  GLenum target_ = GL_NONE;
  GLuint texture_ = 0, buffer_ = 0, depth_texture_ = 0;
};

}  // namespace clipc::values
