// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/upload.h"

#include "tools/draw/opengl/samples.h"

namespace clipc::draw {
namespace {

struct Format {
  GLenum internal, components, type;
};

Format FormatOf(const Inputs::Texture& texture) {
  if (texture.components < 4) {
    constexpr GLenum kInternal[][2] = {
        {GL_R32F, GL_RG32F}, {GL_R32I, GL_RG32I}, {GL_R32UI, GL_RG32UI}};
    constexpr GLenum kComponents[][2] = {{GL_RED, GL_RG}, {GL_RED_INTEGER, GL_RG_INTEGER}};
    const auto kind = static_cast<std::size_t>(texture.kind);
    const auto last = static_cast<std::size_t>(texture.components - 1);
    constexpr GLenum kTypes[] = {GL_FLOAT, GL_INT, GL_UNSIGNED_INT};
    return {kInternal[kind][last], kComponents[kind == 0 ? 0 : 1][last], kTypes[kind]};
  }
  if (texture.compares) return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
  switch (texture.kind) {
    case WordKind::kInt: return {GL_RGBA32I, GL_RGBA_INTEGER, GL_INT};
    case WordKind::kUint: return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT};
    case WordKind::kFloat: break;
  }
  return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
}

void UploadLevel(GLenum target, const Format& format, GLint number,
                 const Inputs::Texture::Level& level) {
  const auto internal = static_cast<GLint>(format.internal);
  const auto [width, height, depth] = level.size;
  const std::uint32_t* words = level.words.data();
  const auto plane = [&](GLenum part, std::size_t first) {
    glTexImage2D(part, number, internal, width, height, 0, format.components, format.type,
                 words + first);
  };
  switch (target) {
    case GL_TEXTURE_1D:
      return glTexImage1D(target, number, internal, width, 0, format.components, format.type,
                          words);
    case GL_TEXTURE_1D_ARRAY:
    case GL_TEXTURE_2D: return plane(target, 0);
    case GL_TEXTURE_CUBE_MAP:
      for (GLenum face = 0; face < 6; ++face)
        plane(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level.words.size() / 6 * face);
      return;
    default:
      return glTexImage3D(target, number, internal, width, height, depth, 0, format.components,
                          format.type, words);
  }
}

// Makes the only level of an image, whose size cannot change: OpenGL ES accepts no others.
void UploadImage(GLenum target, const Format& format, const Inputs::Texture::Level& level) {
  const auto [width, height, depth] = level.size;
  const std::uint32_t* words = level.words.data();
  switch (target) {
    case GL_TEXTURE_1D:
      glTexStorage1D(target, 1, format.internal, width);
      return glTexSubImage1D(target, 0, 0, width, format.components, format.type, words);
    case GL_TEXTURE_1D_ARRAY:
    case GL_TEXTURE_2D:
      glTexStorage2D(target, 1, format.internal, width, height);
      return glTexSubImage2D(target, 0, 0, 0, width, height, format.components, format.type, words);
    default:
      glTexStorage3D(target, 1, format.internal, width, height, depth);
      return glTexSubImage3D(target, 0, 0, 0, 0, width, height, depth, format.components,
                             format.type, words);
  }
}

}  // namespace

void BindImage(const Inputs::Texture& texture, GLuint id, GLuint unit) {
  glBindImageTexture(unit, id, 0, GL_TRUE, 0, GL_READ_WRITE, FormatOf(texture).internal);
}

GLuint UploadTexture(const Inputs::Texture& texture,
                     const std::function<GLuint(const Words& words)>& new_buffer) {
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(texture.target, id);
  const Format format = FormatOf(texture);
  if (texture.target == GL_TEXTURE_BUFFER) {
    glTexBuffer(GL_TEXTURE_BUFFER, format.internal, new_buffer(texture.levels.at(0).words));
    return id;
  }
  if (texture.is_image) {
    UploadImage(texture.target, format, texture.levels.at(0));
    return id;
  }
  if (texture.target == GL_TEXTURE_2D_MULTISAMPLE ||
      texture.target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY) {
    UploadSamples(texture.target, format.internal, format.components, format.type, texture.kind,
                  texture.levels.at(0));
    return id;
  }
  // Before the levels: Mesa 22.3 makes room for one level of a texture whose filter takes no other,
  // and loses the others of an array of 1D textures.
  glTexParameteri(texture.target, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  glTexParameteri(texture.target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(texture.target, GL_TEXTURE_MAX_LEVEL,
                  static_cast<GLint>(texture.levels.size()) - 1);
  for (std::size_t level = 0; level < texture.levels.size(); ++level) {
    UploadLevel(texture.target, format, static_cast<GLint>(level), texture.levels[level]);
  }
  if (texture.compares) {
    glTexParameteri(texture.target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(texture.target, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  }
  return id;
}

}  // namespace clipc::draw
