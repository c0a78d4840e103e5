// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tools/draw/build.h"
#include "tools/draw/opengl/program.h"
#include "tools/harness/drawing.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/offscreen.h"

// Which way the triangles turn that the tessellator makes for clipc's domain shaders.
namespace clipc::draw {
namespace {

constexpr const char* kFragment =
    "#version 450\nout vec4 color;\nvoid main() { color = gl_FrontFacing ? vec4(0, 1, 0, 1) : "
    "vec4(1, 0, 0, 1); }\n";
// Clockwise on the screen, where y grows upwards.
constexpr const char* kCorners =
    "#version 450\nvoid main() { gl_Position = vec4(gl_VertexID == 2 ? 1 : -1, gl_VertexID == 1 ? "
    "1 : -1, 0, 1); }\n";

std::string Control(int points) {
  return "#version 450\nlayout(vertices = " + std::to_string(points) +
         ") out;\nvoid main() {\n"
         "    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
         "    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = 2;\n"
         "    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = 2;\n}\n";
}

// The GLSL of a domain shader whose hull shader, in the same file, has the topology.
std::string Domain(const std::string& shape, const std::string& topology, bool flip_y) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("clipc_winding_" + shape + topology + (flip_y ? "_flipped" : "") + ".hlsl");
  const bool is_quad = shape == "quad";
  std::ofstream(path)
      << "struct P { float4 p : SV_Position; };\n[domain(\"" << shape << "\")]\nfloat4 main(const "
      << (is_quad ? "OutputPatch<P, 1> v, float2 at : SV_DomainLocation) : SV_Position { return "
                    "float4(2 * at.x - 1, 1 - 2 * at.y, v[0].p.z, 1); }\n"
                  : "OutputPatch<P, 3> v, float3 at : SV_DomainLocation) : SV_Position { return "
                    "v[0].p * at.x + v[1].p * at.y + v[2].p * at.z; }\n")
      << "[domain(\"" << shape << "\")] [partitioning(\"integer\")] [outputtopology(\"" << topology
      << "\")] void hull() {}\n";
  BuildOptions options;
  options.path = path.string();
  options.profile = "ds_5_0";
  options.clip_space.flip_y = flip_y;
  const Shader shader = Build(options);
  std::filesystem::remove(path);
  return shader.glsl;
}

// Whether a pixel at the left edge, which all triangles here cover, is of one that faces the
// viewer.
bool IsFront(const std::string& evaluation, int points) {
  const harness::StageText stages[] = {
      {GL_VERTEX_SHADER, kCorners},
      {GL_TESS_CONTROL_SHADER, evaluation.empty() ? "" : Control(points)},
      {GL_TESS_EVALUATION_SHADER, evaluation},
      {GL_FRAGMENT_SHADER, kFragment}};
  const harness::Framebuffer framebuffer(8, 8);
  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const GlProgram program(stages, {});
  glUseProgram(program.id());
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glPatchParameteri(GL_PATCH_VERTICES, points);
  glDrawArrays(evaluation.empty() ? GL_TRIANGLES : GL_PATCHES, 0, points);
  unsigned char pixel[4] = {};
  glReadPixels(1, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  glDeleteVertexArrays(1, &array);
  EXPECT_EQ(pixel[2], 0) << "nothing is drawn";
  return pixel[1] > 0;
}

TEST(Winding, TrianglesTurnAsTheirControlPoints) {
  harness::OpenGl opengl(harness::Api::kCore);
  const bool direct = IsFront("", 3);
  EXPECT_FALSE(direct);
  EXPECT_EQ(IsFront(Domain("tri", "triangle_cw", false), 3), direct);
  EXPECT_NE(IsFront(Domain("tri", "triangle_ccw", false), 3), direct);
}

// Direct3D's v grows downwards in the domain.
TEST(Winding, SquaresTurnAsTheirDomain) {
  harness::OpenGl opengl(harness::Api::kCore);
  EXPECT_FALSE(IsFront(Domain("quad", "triangle_cw", false), 1));
  EXPECT_TRUE(IsFront(Domain("quad", "triangle_ccw", false), 1));
}

// --flip-y mirrors them, as it mirrors the triangles of a vertex shader.
TEST(Winding, AMirroredImageTurnsTheOtherWay) {
  harness::OpenGl opengl(harness::Api::kCore);
  EXPECT_TRUE(IsFront(Domain("tri", "triangle_cw", true), 3));
  EXPECT_TRUE(IsFront(Domain("quad", "triangle_cw", true), 1));
}

}  // namespace
}  // namespace clipc::draw
