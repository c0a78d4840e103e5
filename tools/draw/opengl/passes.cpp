// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/passes.h"

#include <algorithm>
#include <vector>

#include "tools/draw/opengl/pair.h"
#include "tools/draw/pair.h"
#include "tools/harness/framebuffer.h"

namespace clipc::draw {
namespace {

constexpr char kFragment[] = "#version 450\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n";

// Draws white where the depth test passes.
void Draw(const std::string& vertex) {
  GlProgram program(vertex, kFragment, {});
  const Inputs inputs = MeshInputs(program);
  program.Bind(inputs);
  glDrawArrays(GL_TRIANGLES, 0, inputs.vertices);
}

int WhitePixels(const harness::Framebuffer& framebuffer) {
  const std::vector<float> red = framebuffer.ReadFloats(GL_RED);
  return static_cast<int>(std::ranges::count(red, 1.0f));
}

}  // namespace

PassesDifference ComparePasses(const std::string& first, const std::string& second) {
  const harness::Framebuffer framebuffer(kPairSize, kPairSize,
                                         {.color = GL_RGBA32F, .depth = GL_DEPTH_COMPONENT32F});
  glClearColor(0, 0, 0, 0);
  glEnable(GL_DEPTH_TEST);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  Draw(first);
  const int drawn = WhitePixels(framebuffer);
  glClear(GL_COLOR_BUFFER_BIT);
  glDepthFunc(GL_EQUAL);
  Draw(second);
  const int equal = WhitePixels(framebuffer);
  glDisable(GL_DEPTH_TEST);
  harness::CheckErrors("drawing");
  return {drawn, drawn - equal};
}

}  // namespace clipc::draw
