// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/geometry.h"

#include <array>

namespace clipc::draw {
namespace {

// The text with points in place of strips.
std::string WithPoints(std::string text) {
  for (const std::string_view strip : {"triangle_strip", "line_strip"}) {
    if (const std::size_t at = text.find(strip); at != text.npos)
      text.replace(at, strip.size(), "points");
  }
  return text;
}

// Throws DrawError where the strips end at other vertices than in the HLSL, so that they have
// another number of lines or triangles.
void CheckStrips(const std::string& geometry, GeometryRun run, const std::string& name,
                 const Trial& trial, const Inputs& inputs) {
  const std::uint32_t vertices = InfoOf(trial.shader.typed.emission.output).vertices;
  if (vertices < 2) return;
  run.geometry = geometry;
  const auto expected = CountPrimitives(trial.shader, trial.inputs);
  if (!expected) return;  // llvmpipe of Mesa 22.3 crashes at strips that are too short
  const std::size_t found =
      CountEmitted(run, name, inputs, vertices == 2 ? GL_LINES : GL_TRIANGLES);
  if (found != *expected)
    throw DrawError("the strips have " + std::to_string(found) + " primitives, those of the HLSL " +
                    std::to_string(*expected));
}

}  // namespace

PassedOn PassOnInto(Inputs& inputs, const Version& version, const Shader& shader,
                    const RandomInputs& random) {
  PassedOn passed = PassOn(shader, random, version.es ? PassOnFor::kOpenGlEs : PassOnFor::kOpenGl);
  inputs.first_vertex = inputs.base_instance = 0;
  inputs.instances = 1;
  inputs.vertices = passed.vertices;
  inputs.attributes.clear();
  for (const PassedOn::Attribute& attribute : passed.attributes)
    inputs.attributes.push_back({attribute.name, attribute.words});
  return passed;
}

std::vector<Captured> Emit(const std::string& geometry, std::span<const std::string> names,
                           const Trial& trial, Inputs inputs) {
  constexpr std::array<GLenum, 5> kModes = {GL_POINTS, GL_LINES, GL_TRIANGLES, GL_LINES_ADJACENCY,
                                            GL_TRIANGLES_ADJACENCY};
  const ir::Emission& emission = trial.shader.lowered.emission;
  const Version version = VersionOf(geometry);
  GeometryRun run;
  run.vertex = version.Head() + PassOnInto(inputs, version, trial.shader, trial.inputs).vertex;
  run.geometry = WithPoints(geometry);
  run.primitive = kModes[static_cast<std::size_t>(emission.input)];
  run.most_vertices = MostEmitted(emission, inputs.vertices);
  CheckStrips(geometry, run, names.front(), trial, inputs);
  return CaptureGeometry(run, names, inputs);
}

}  // namespace clipc::draw
