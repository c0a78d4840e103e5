// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/values/resource.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "tools/harness/drawing.h"
#include "tools/harness/offscreen.h"

namespace clipc::values {
namespace {

// A framebuffer that is gone at the end, with what was bound before bound again.
class Framebuffer : NotCopied {
 public:
  explicit Framebuffer(GLenum place) : place_(place) {
    glGetIntegerv(
        place == GL_READ_FRAMEBUFFER ? GL_READ_FRAMEBUFFER_BINDING : GL_DRAW_FRAMEBUFFER_BINDING,
        &before_);
    glGenFramebuffers(1, &id_);
    glBindFramebuffer(place, id_);
  }
  ~Framebuffer() {
    glBindFramebuffer(place_, static_cast<GLuint>(before_));
    glDeleteFramebuffers(1, &id_);
  }

 private:
  GLenum place_;
  GLint before_ = 0;
  GLuint id_ = 0;
};

GLenum TargetOf(const ResourceText& text) {
  switch (text.dimension) {
    case Dimension::kBuffer: return GL_TEXTURE_BUFFER;
    case Dimension::k2d: return text.samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    case Dimension::k2dArray: return GL_TEXTURE_2D_ARRAY;
    case Dimension::k3d: return GL_TEXTURE_3D;
    case Dimension::kCube: return GL_TEXTURE_CUBE_MAP;
  }
  return GL_TEXTURE_2D;
}

std::uint32_t AtLevel(std::uint32_t size, std::uint32_t level) {
  return std::max(size >> level, 1u);
}

}  // namespace

Resource::Resource(ResourceText text) : text_(std::move(text)), target_(TargetOf(text_)) {
  if (text_.dimension == Dimension::kBuffer) {
    const std::size_t bytes =
        text_.role == Role::kVertices ? text_.width : std::size_t{text_.width} * text_.TexelSize();
    text_.words.resize((bytes + 3) / 4);
    buffer_ = harness::NewBuffer(GL_COPY_WRITE_BUFFER, text_.words.data(), 4 * text_.words.size());
    if (text_.stride != 0 || text_.is_raw || text_.role == Role::kVertices) return;
    glGenTextures(1, &texture_);
    glBindTexture(target_, texture_);
    glTexBuffer(target_, text_.format.internal, buffer_);
    return;
  }
  texture_ = Upload(text_.format);
  harness::CheckErrors("making a resource");
}

Resource::~Resource() {
  glDeleteTextures(1, &texture_);
  glDeleteTextures(1, &depth_texture_);
  glDeleteBuffers(1, &buffer_);
}

GLuint Resource::DepthTexture() {
  if (text_.format.components == GL_DEPTH_COMPONENT) return texture_;
  if (depth_texture_ == 0)
    depth_texture_ = Upload({"", GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 1});
  return depth_texture_;
}

GLuint Resource::Upload(const Format& format) const {
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(target_, id);
  const auto width = static_cast<GLsizei>(text_.width), height = static_cast<GLsizei>(text_.height);
  const auto depth = static_cast<GLsizei>(text_.depth);
  const auto levels = static_cast<GLsizei>(text_.levels);
  if (text_.samples > 1) {
    glTexStorage2DMultisample(target_, static_cast<GLsizei>(text_.samples), format.internal, width,
                              height, GL_TRUE);
    return id;
  }
  const bool is_flat = text_.dimension == Dimension::k2d || text_.dimension == Dimension::kCube;
  is_flat ? glTexStorage2D(target_, levels, format.internal, width, height)
          : glTexStorage3D(target_, levels, format.internal, width, height, depth);
  // Of a texel only the components of `format` are read, which are the first of it.
  std::vector<std::uint32_t> words;
  for (std::size_t i = 0; i < text_.words.size(); i += text_.format.count) {
    for (std::size_t k = 0; k < format.count; ++k)
      words.push_back(i + k < text_.words.size() ? text_.words[i + k] : 0);
  }
  const std::uint32_t* next = words.data();
  const std::uint32_t* end = next + words.size();
  for (GLint level = 0; level < levels; ++level) {
    const std::uint32_t w = AtLevel(text_.width, level), h = AtLevel(text_.height, level);
    const std::uint32_t d =
        text_.dimension == Dimension::k3d ? AtLevel(text_.depth, level) : text_.depth;
    const std::size_t plane = std::size_t{w} * h * format.count;
    if (static_cast<std::size_t>(end - next) < plane * d) break;  // no texels are given
    const auto x = static_cast<GLsizei>(w), y = static_cast<GLsizei>(h);
    for (std::uint32_t z = 0; z < d; ++z, next += plane) {
      if (text_.dimension == Dimension::k2d) {
        glTexSubImage2D(target_, level, 0, 0, x, y, format.components, format.type, next);
      } else if (text_.dimension == Dimension::kCube) {
        glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + z, level, 0, 0, x, y, format.components,
                        format.type, next);
      } else {
        glTexSubImage3D(target_, level, 0, 0, static_cast<GLint>(z), x, y, 1, format.components,
                        format.type, next);
      }
    }
  }
  return id;
}

std::vector<std::uint8_t> Resource::Read() const {
  if (text_.dimension == Dimension::kBuffer) {
    std::vector<std::uint8_t> bytes(4 * text_.words.size());
    glBindBuffer(GL_COPY_READ_BUFFER, buffer_);
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
    return bytes;
  }
  if (text_.samples > 1) {
    ResourceText text = text_;
    text.samples = 1;
    text.role = Role::kTexture;
    Resource single(text);
    single.CopyFrom(*this);
    return single.Read();
  }
  const std::size_t row = std::size_t{text_.width} * text_.TexelSize();
  std::vector<std::uint8_t> bytes(row * text_.height * text_.depth);
  glBindTexture(target_, texture_);
  glGetTexImage(target_, 0, text_.format.components, text_.format.type, bytes.data());
  if (is_flipped()) {
    for (std::size_t layer = 0; layer < text_.depth; ++layer) {
      std::uint8_t* first = bytes.data() + row * text_.height * layer;
      for (std::size_t y = 0; y < text_.height / 2; ++y)
        std::swap_ranges(first + y * row, first + (y + 1) * row,
                         first + (text_.height - 1 - y) * row);
    }
  }
  harness::CheckErrors("reading a resource");
  return bytes;
}

void Resource::CopyFrom(const Resource& other) {
  const bool is_depth = text_.format.components == GL_DEPTH_COMPONENT;
  const GLenum place = is_depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0;
  const Framebuffer from(GL_READ_FRAMEBUFFER), to(GL_DRAW_FRAMEBUFFER);
  const auto width = static_cast<GLint>(text_.width), height = static_cast<GLint>(text_.height);
  glFramebufferTexture(GL_READ_FRAMEBUFFER, place, other.texture_, 0);
  glFramebufferTexture(GL_DRAW_FRAMEBUFFER, place, texture_, 0);
  const bool turns = is_flipped() != other.is_flipped();
  glBlitFramebuffer(0, 0, width, height, 0, turns ? height : 0, width, turns ? 0 : height,
                    is_depth ? GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT, GL_NEAREST);
  harness::CheckErrors("copying a resource");
}

void Resource::Clear(const std::array<float, 4>& values) const {
  const bool is_depth = text_.format.components == GL_DEPTH_COMPONENT;
  const Framebuffer to(GL_DRAW_FRAMEBUFFER);
  glFramebufferTexture(GL_DRAW_FRAMEBUFFER, is_depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                       texture_, 0);
  std::array<GLint, 4> integers{};
  for (int i = 0; i < 4; ++i)
    integers[i] = static_cast<GLint>(static_cast<std::int64_t>(values[i]));
  if (is_depth) {
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_DEPTH, 0, values.data());
  } else if (text_.format.type == GL_FLOAT) {
    glClearBufferfv(GL_COLOR, 0, values.data());
  } else if (text_.format.type == GL_INT) {
    glClearBufferiv(GL_COLOR, 0, integers.data());
  } else {
    const auto bits = std::bit_cast<std::array<GLuint, 4>>(integers);
    glClearBufferuiv(GL_COLOR, 0, bits.data());
  }
  harness::CheckErrors("clearing a resource");
}

}  // namespace clipc::values
