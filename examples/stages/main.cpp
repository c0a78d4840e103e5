// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Draws what the shaders of examples/compute, geometry and tessellation make.
//   stages EXAMPLES NAME     writes NAME.png
#include <cstdio>
#include <exception>
#include <string_view>

#include "examples/stages/images.h"
#include "tools/harness/offscreen.h"

namespace {

struct Example {
  std::string_view name;
  stages::Image (*draw)(const stages::Folder& examples);
};
constexpr Example kExamples[] = {
    {"blur", stages::DrawBlur},
    {"histogram", stages::DrawHistogram},
    {"prefix_sums", stages::DrawPrefixSums},
    {"particles", stages::DrawParticles},
    {"cube_map", stages::DrawCubeMap},
    {"shadow_volume", stages::DrawShadowVolume},
    {"fur", stages::DrawFur},
    {"tessellated_terrain", stages::DrawTerrain},
};

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) throw stages::DrawError("usage: stages EXAMPLES NAME");
  const stages::OpenGl opengl(stages::Api::kCore);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);  // depth as Direct3D has it
  for (const auto& [name, draw] : kExamples) {
    if (name != argv[2]) continue;
    stages::WritePng(std::string(name) + ".png", draw(argv[1]));
    return 0;
  }
  throw stages::DrawError("no example is called `" + std::string(argv[2]) + "`");
} catch (const std::exception& error) {
  std::fprintf(stderr, "stages: %s\n", error.what());
  return 1;
}
