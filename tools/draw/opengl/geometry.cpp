// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/geometry.h"

#include <array>

#include "tools/draw/pass_on.h"

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

}  // namespace

std::vector<Captured> Emit(const std::string& geometry, std::span<const std::string> names,
                           const Trial& trial, Inputs inputs) {
  constexpr std::array<GLenum, 5> kModes = {GL_POINTS, GL_LINES, GL_TRIANGLES, GL_LINES_ADJACENCY,
                                            GL_TRIANGLES_ADJACENCY};
  const Version version = VersionOf(geometry);
  const PassedOn passed = PassOn(trial, version.es ? PassOnFor::kOpenGlEs : PassOnFor::kOpenGl);
  inputs.attributes.clear();
  for (const PassedOn::Attribute& attribute : passed.attributes)
    inputs.attributes.push_back({attribute.name, attribute.words});
  inputs.first_vertex = inputs.base_instance = 0;
  inputs.instances = 1;
  inputs.vertices = passed.vertices;
  const std::string extension =
      version.es && version.number < 320 ? "#extension GL_EXT_shader_io_blocks : enable\n" : "";
  GeometryRun run;
  run.vertex = version.Line() + extension + passed.text;
  run.geometry = WithPoints(geometry);
  run.primitive = kModes[static_cast<std::size_t>(trial.shader.lowered.emission.input)];
  run.most_vertices = passed.most_vertices;
  return CaptureGeometry(run, names, inputs);
}

}  // namespace clipc::draw
