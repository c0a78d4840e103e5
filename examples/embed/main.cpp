// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// An engine that compiles HLSL while it draws: libclipc.so in its process, beside the driver, which
// for Mesa's software OpenGL contains another LLVM. One thread draws a cube, clipped by a plane
// that the shader names; the others compile variants of the same shader all the while. The image
// must be clipped where the plane is, and every compile of one variant must give the same bytes.
//   embed [FILE.png]
#include <atomic>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <clipc/clipc.hpp>
#include <clipc/runtime/clip_plane.h>
#include <clipc/runtime/gl/clip_switches.h>
#include <clipc/runtime/table.h>

#include "tools/harness/camera.h"
#include "tools/harness/check.h"
#include "tools/harness/drawing.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/offscreen.h"

namespace {

using namespace clipc::harness;
namespace library = clipc::library;
namespace runtime = clipc::runtime;

constexpr int kSize = 128;
constexpr int kThreads = 3;

// The engine's files, all in memory.
const std::map<std::string, std::string> kFiles = {
    {"shaders/cut.hlsl",
     "#include \"clip.hlsli\"\n"
     R"(
cbuffer Object : register(b0) { float4x4 world_view_projection; };
[clipplanes(cut)]
float4 main(float3 position : POSITION) : SV_Position {
  return mul(float4(position * SCALE, 1), world_view_projection);
}
)"},
    {"shaders/clip.hlsli", "cbuffer Clip : register(b1) { float4 cut; };\n"}};

library::Result Compile(library::Compiler& compiler, int scale) {
  library::Request request;
  request.path = "shaders/cut.hlsl";
  request.text = kFiles.at(request.path);
  request.options = {"-T", "vs_5_0", "--blocks=flat", "-D", "SCALE=" + std::to_string(scale)};
  request.read_include = [](const std::string& path) -> std::optional<std::string> {
    const auto found = kFiles.find(path);
    if (found == kFiles.end()) return std::nullopt;
    return found->second;
  };
  library::Result result = compiler.Compile(request);
  if (!result.ok()) throw DrawError(std::string(result.messages()));
  return result;
}

// Compiles until `is_done`, and adds the GLSL for each scale to `texts`.
void KeepCompiling(const std::atomic<bool>& is_done, std::map<int, std::set<std::string>>& texts) {
  library::Compiler compiler;
  for (int i = 0; !is_done || i < 8; ++i) texts[i % 4].emplace(Compile(compiler, 1 + i % 4).glsl());
}

// The rows of pixels that the cube covers.
int RowsCovered(const Image& image) {
  int rows = 0;
  for (int y = 0; y < image.height; ++y) {
    bool is_covered = false;
    for (int x = 0; x < image.width; ++x)
      is_covered |= image.rgba[4 * static_cast<std::size_t>(y * image.width + x)] > 128;
    rows += is_covered ? 1 : 0;
  }
  return rows;
}

// Draws the cube; if `is_clipped`, the plane removes its upper half.
Image Draw(bool is_clipped) {
  library::Compiler compiler;
  const library::Result shader = Compile(compiler, 1);
  const std::string_view json = shader.Get(CLIPC_PART_TABLE_JSON);
  const runtime::Table table = Check(runtime::ReadTable(json.data(), json.size()));
  runtime::gl::ClipSwitches switches(Check(runtime::gl::LoadFunctions(OpenGl::Load)));
  const Matrix view = LookAt({0, 0, -6}, {0, 0, 0}), projection = Perspective(0.62, 1, 1, 20);
  const Canvas canvas(kSize, kSize);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const Program program(std::string(shader.glsl()),
                        "#version 450\nlayout(location = 0) out vec4 color;\n"
                        "void main() { color = vec4(1.0); }\n");
  program.Use();
  program.Set("world_view_projection", Floats(Multiply(view, projection)));
  const runtime::Plane world = {0, is_clipped ? -1.0 : 0.0, 0, is_clipped ? 0.0 : 1.0};
  const runtime::Float4 cut =
      is_clipped ? Check(runtime::ClipPlaneFromWorld(world, view, projection)).constant
                 : runtime::Float4{};  // the zero plane keeps everything
  program.Set(table.planes[0].glsl_member, cut.x, cut.y, cut.z, cut.w);
  Check(switches.Bind(table));
  MeshBuffers(Cube()).Draw();
  return canvas.Read();
}

void Run(const std::string& path) {
  std::atomic<bool> is_done = false;
  std::vector<std::map<int, std::set<std::string>>> texts(kThreads);
  std::vector<std::thread> threads;
  for (auto& own : texts) threads.emplace_back(KeepCompiling, std::cref(is_done), std::ref(own));
  std::exception_ptr problem;
  Image whole, clipped;
  try {
    const OpenGl opengl(Api::kCore);
    for (int i = 0; i < 5; ++i) {
      whole = Draw(false);
      clipped = Draw(true);
    }
  } catch (...) {
    problem = std::current_exception();
  }
  is_done = true;
  for (std::thread& thread : threads) thread.join();
  if (problem) std::rethrow_exception(problem);
  WritePng(path, clipped);
  for (const auto& own : texts) {
    for (const auto& [scale, said] : own) {
      if (said != texts[0][scale] || said.size() != 1)
        throw DrawError("compiles of one shader differ");
    }
  }
  const int rows = RowsCovered(whole), left = RowsCovered(clipped);
  std::printf("%d rows of pixels without the plane, %d with it\n", rows, left);
  if (rows < kSize / 4 || std::abs(2 * left - rows) > 4)
    throw DrawError("the plane does not halve the cube");
}

}  // namespace

int main(int argc, char** argv) try {
  Run(argc > 1 ? argv[1] : "embed.png");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "embed: %s\n", error.what());
  return 1;
}
