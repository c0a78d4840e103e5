// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "examples/stages/images.h"

#include <algorithm>
#include <vector>

#include "tools/harness/offscreen.h"
#include "tools/harness/options.h"

namespace stages {

void UseProgram(const std::string& vertex, std::initializer_list<StageFile> files,
                const std::string& fragment) {
  std::vector<StageText> stages = {{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}};
  for (const auto& [stage, path] : files) stages.push_back({stage, ReadFile(path)});
  glUseProgram(LinkStages(stages));
}

void UseCompute(const std::string& path) { glUseProgram(LinkComputeProgram(ReadFile(path))); }

GLuint BindBuffer(GLenum target, GLuint binding, const void* bytes, std::size_t size) {
  const GLuint buffer = NewBuffer(target, bytes, size);
  glBindBufferBase(target, binding, buffer);
  return buffer;
}

Image ImageOf(GLuint texture, int width, int height) {
  Image image{width, height, {}};
  image.rgba.resize(std::size_t{4} * static_cast<std::size_t>(width * height));
  glGetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(image.rgba.size()),
                    image.rgba.data());
  CheckErrors("reading the texture");
  const auto row = std::ptrdiff_t{4} * width;
  for (int y = 0; y < height / 2; ++y)
    std::swap_ranges(image.rgba.begin() + y * row, image.rgba.begin() + (y + 1) * row,
                     image.rgba.end() - (y + 1) * row);
  return image;
}

}  // namespace stages
