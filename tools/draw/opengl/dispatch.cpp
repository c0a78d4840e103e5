// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/dispatch.h"

#include <cstring>

#include "tools/draw/dispatch.h"
#include "tools/draw/opengl/program.h"
#include "tools/harness/drawing.h"

namespace clipc::draw {
namespace {

// The bytes of the buffer that is bound to the target.
Bytes MappedBytes(GLenum target, std::size_t size) {
  const void* mapped = glMapBufferRange(target, 0, static_cast<GLsizeiptr>(size), GL_MAP_READ_BIT);
  if (!mapped) throw DrawError("reading what a compute shader wrote");
  Bytes bytes(size);
  std::memcpy(bytes.data(), mapped, size);
  glUnmapBuffer(target);
  return bytes;
}

Bytes ReadStorage(const Inputs::Storage& storage) {
  GLint buffer = 0;
  glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, storage.binding, &buffer);
  glBindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(buffer));
  return MappedBytes(GL_COPY_READ_BUFFER, storage.bytes.size());
}

// The words of an image's texels, without those that it does not have.
Words ReadTexels(const Inputs::Texture& image, GLuint texture) {
  constexpr GLenum kFloats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  constexpr GLenum kIntegers[] = {GL_RED_INTEGER, GL_RG_INTEGER, GL_RGB_INTEGER, GL_RGBA_INTEGER};
  constexpr GLenum kTypes[] = {GL_FLOAT, GL_INT, GL_UNSIGNED_INT};  // by WordKind
  Words words(image.levels.at(0).words.size());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(image.target, texture);
  if (image.target == GL_TEXTURE_BUFFER) {
    GLint buffer = 0;
    glGetTexLevelParameteriv(image.target, 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &buffer);
    glBindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(buffer));
    const Bytes bytes = MappedBytes(GL_COPY_READ_BUFFER, 4 * words.size());
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
  }
  const bool is_float = image.kind == WordKind::kFloat;
  glGetTexImage(image.target, 0, (is_float ? kFloats : kIntegers)[image.components - 1],
                kTypes[static_cast<int>(image.kind)], words.data());
  return words;
}

}  // namespace

std::map<std::string, Bytes> Dispatch(const std::string& compute, const Inputs& inputs) {
  GlProgram program(compute);
  program.Bind(inputs);
  glDispatchCompute(kGroups[0], kGroups[1], kGroups[2]);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  harness::CheckErrors("running the compute shader");
  std::map<std::string, Bytes> memory;
  for (const Inputs::Storage& storage : inputs.storage)
    memory.emplace(storage.name, ReadStorage(storage));
  if (!VersionOf(compute).es) {
    for (const GlProgram::BoundImage& bound : program.images())
      memory.emplace(bound.image->name,
                     MemoryOfTexels(*bound.image, ReadTexels(*bound.image, bound.texture)));
  }
  harness::CheckErrors("reading what the compute shader wrote");
  return memory;
}

}  // namespace clipc::draw
