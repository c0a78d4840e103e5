// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/domain.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "tools/draw/opengl/geometry.h"
#include "tools/draw/pass_patch.h"

namespace clipc::draw {
namespace {

constexpr std::string_view kLayoutEnd = ") in;";

// The part of a domain shader's text up to the end of its layout of the tessellator, and beyond it
// the rest.
std::pair<std::string, std::string> AtLayout(const std::string& text) {
  const std::size_t end = text.find(kLayoutEnd, text.find("_spacing"));
  return {text.substr(0, end), text.substr(end)};
}

// The text with points in place of triangles and lines.
std::string WithPointMode(const std::string& text) {
  const auto [layout, rest] = AtLayout(text);
  return layout.rfind("point_mode") == layout.npos ? layout + ", point_mode" + rest : text;
}

}  // namespace

std::vector<DomainPoint> PointsOf(harness::OpenGl& opengl, const Shader& shader,
                                  const RandomInputs& random) {
  const std::string head = "#version 450\n", layout = AtLayout(shader.glsl).first;
  opengl.Use(VersionOf(head).api);
  PatchRun run;
  run.vertex = head + "void main() { gl_Position = vec4(0.0); }\n";
  run.control = head + "layout(vertices = 1) out;\nvoid main() {\n" + FactorValuesText() + "}\n";
  run.evaluation =
      WithPointMode(head + layout.substr(layout.rfind("layout(")) + std::string(kLayoutEnd) +
                    "\nout vec3 test_at;\nout float test_patch;\nvoid main() {\n"
                    "    test_at = gl_TessCoord;\n"
                    "    test_patch = float(gl_PrimitiveID);\n}\n");
  Inputs inputs;
  inputs.vertices = static_cast<int>(random.vertices.size()) / VerticesOfOne(shader.lowered);
  run.most_points = inputs.vertices * kMostPoints;
  const std::string names[] = {"test_at", "test_patch"};
  const std::vector<Captured> captured = CapturePatches(run, names, inputs);
  std::vector<DomainPoint> points(captured[1].words.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::copy_n(captured[0].words.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                points[i].at.begin());
    points[i].patch = static_cast<std::uint32_t>(std::bit_cast<float>(captured[1].words[i]));
  }
  return points;
}

std::vector<Captured> Evaluate(const std::string& domain, std::span<const std::string> names,
                               const Trial& trial, Inputs inputs) {
  const Version version = VersionOf(domain);
  const PassedOn passed = PassOnInto(inputs, version, trial.shader, trial.inputs);
  // Mesa's gl_PerVertex of OpenGL ES is another one in stages without the extension.
  constexpr std::string_view kDistances = "#extension GL_EXT_clip_cull_distance : require\n";
  const std::string head =
      version.Head() + (domain.find(kDistances) == domain.npos ? "" : std::string(kDistances));
  PatchRun run;
  run.vertex = head + passed.vertex;
  run.control = head + passed.hull;
  run.evaluation = WithPointMode(domain);
  run.patch_vertices = VerticesOfOne(trial.shader.lowered);
  run.most_points = inputs.vertices / run.patch_vertices * kMostPoints;
  return CapturePatches(run, names, inputs);
}

}  // namespace clipc::draw
