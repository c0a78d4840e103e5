// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/compare.h"
#include "tools/draw/feed.h"

namespace clipc::draw {
namespace {

// Mesa 22.3 does not capture cull distances: there they are an output like any other.
std::string Capturable(std::string text) {
  constexpr std::string_view kCull = "gl_CullDistance";
  for (std::size_t at = text.find(kCull); at != std::string::npos; at = text.find(kCull, at)) {
    text.replace(at, kCull.size(), "cull_distance");
  }
  return text;
}

}  // namespace

Comparison CompareWithOpenGl(Device& device, const Shader& shader,
                             const std::vector<Expected>& expected, const RandomInputs& random,
                             const RandomOptions& draw, const Tolerance& tolerance) {
  const std::string text = Capturable(ForOpenGl(shader.glsl));
  const Gl& gl = device.Use(VersionOf(text).api);
  const std::vector<const Expected*> outputs = Defined(expected);
  std::vector<std::string> names;
  for (const Expected* output : outputs) names.push_back(Capturable(output->name));
  if (outputs.empty()) return {};
  return CompareOutputs(
      outputs, Capture(gl, text, names, MakeInputs(shader.lowered, shader.info, random, draw)),
      tolerance);
}

}  // namespace clipc::draw
