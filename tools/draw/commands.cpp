// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/commands.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <utility>

#include "tools/draw/arguments.h"
#include "tools/draw/opengl/image.h"
#include "tools/draw/opengl/pair.h"
#include "tools/draw/opengl/passes.h"
#include "tools/draw/opengl/program.h"
#include "tools/draw/vulkan/machine_code.h"
#include "tools/draw/vulkan/pair.h"
#include "tools/draw/vulkan/run.h"
#include "tools/draw/vulkan/spirv.h"
#include "tools/harness/drawing.h"
#include "tools/harness/offscreen.h"
#include "tools/harness/options.h"

namespace clipc::draw {
namespace {

using namespace harness::options;
using harness::ReadFile;

Flag BlockFlag(Inputs& inputs) {
  return With([&](auto& value) { AddBlock(value, inputs); });
}

void Print(const Captured& output, int vertex) {
  const int size = output.layout.Words() * output.count;
  std::printf("%d %s =", vertex, output.name.c_str());
  for (int i = 0; i < size; ++i) {
    const std::uint32_t word = output.words[vertex * size + i];
    switch (output.layout.kind) {
      case WordKind::kFloat:
        std::printf(" %.9g", static_cast<double>(std::bit_cast<float>(word)));
        break;
      case WordKind::kInt: std::printf(" %d", static_cast<std::int32_t>(word)); break;
      case WordKind::kUint: std::printf(" %u", word); break;
    }
  }
  std::printf("\n");
}

// Adds the attribute of the position, with as many components as the shader declares.
void AddMesh(const std::vector<Active>& attributes, Inputs& inputs) {
  const std::vector<std::array<float, 4>> mesh = FullTarget();
  inputs.vertices = static_cast<int>(mesh.size());
  const auto position = std::ranges::find(attributes, "in_POSITION0", &Active::name);
  if (position == attributes.end()) return;
  const int components = LayoutOf(*position).rows;
  Words& words = inputs.attributes.emplace_back(Inputs::Attribute{position->name, {}}).words;
  for (const auto& [x, y, z, w] : mesh) {
    const float divisor = components == 4 ? 1 : w;
    const float values[] = {x / divisor, y / divisor, z / divisor, w};
    for (int i = 0; i < components; ++i) words.push_back(std::bit_cast<std::uint32_t>(values[i]));
  }
}

// What OpenGL says of each pair of shaders that it refuses; empty texts of the others.
std::vector<std::string> LinkOnOpenGl(const std::vector<std::string>& texts) {
  harness::OpenGl opengl;
  std::vector<std::string> said;
  for (std::size_t i = 0; i < texts.size(); i += 2) {
    said.emplace_back();
    opengl.Use(VersionOf(texts[i]).api);
    try {
      glDeleteProgram(harness::LinkProgram(texts[i], texts[i + 1]));
    } catch (const DrawError& error) {
      said.back() = error.what();
    }
  }
  return said;
}

std::vector<std::string> LinkOnVulkan(const std::vector<std::string>& texts) {
  std::vector<vulkan::SpirvPair> pairs;
  for (std::size_t i = 0; i < texts.size(); i += 2)
    pairs.push_back({vulkan::SpirvOfBytes(texts[i]), vulkan::SpirvOfBytes(texts[i + 1])});
  return vulkan::LinkPrograms(pairs);
}

struct PixelsOptions {
  std::string png;
  ImageOptions image;
  Expectation expectation;
  bool any_depth = false;
};

Flags PixelsFlags(PixelsOptions& options, Inputs& inputs) {
  return {
      {"block", BlockFlag(inputs)},
      {"uniform", With([&](auto& value) { AddUniform(value, inputs); })},
      {"enable", Number(options.image.enable_mask)},
      {"clip-plane", With([&](auto& value) {
         if (value.size() < 3 || value[0] < '0' || value[0] > '7' || value[1] != '=') {
           throw DrawError("--clip-plane 0=1,0,0,0, not `" + value + "`");
         }
         options.image.clip_planes[value[0] - '0'] = ParsePlane(value.substr(2));
       })},
      {"fragment", With([&](auto& value) { options.image.fragment = ReadFile(value); })},
      {"zero-to-one", On(options.image.zero_to_one)},
      {"expect-plane",
       With([&](auto& value) { options.expectation.planes.push_back(ParsePlane(value)); })},
      {"expect-flipped", On(options.expectation.flipped)},
      {"expect-any-depth", On(options.any_depth)},
      {"png", Text(options.png)},
  };
}

}  // namespace

int RunCapture(const Arguments& arguments) {
  Inputs inputs;
  std::vector<std::string> outputs;
  const std::string vertex = ReadFile(ParseOnlyPath(
      arguments, {{"attribute", With([&](auto& value) { AddAttribute(value, inputs); })},
                  {"block", BlockFlag(inputs)},
                  {"output", Append(outputs)}}));
  if (outputs.empty()) {
    outputs.push_back("gl_Position");
    if (vertex.find("gl_ClipDistance[") != vertex.npos) outputs.push_back("gl_ClipDistance");
  }
  if (inputs.vertices == 0) inputs.vertices = 1;

  const harness::OpenGl opengl(VersionOf(vertex).api);
  const std::vector<Captured> captured = Capture(vertex, outputs, inputs);
  for (int i = 0; i < inputs.vertices; ++i) {
    for (const Captured& output : captured) Print(output, i);
  }
  return 0;
}

int RunPixels(const Arguments& arguments) {
  Inputs inputs;
  PixelsOptions options;
  const std::string vertex = ReadFile(ParseOnlyPath(arguments, PixelsFlags(options, inputs)));

  const Version version = VersionOf(vertex);
  const harness::OpenGl opengl(version.api);
  {
    const GlProgram program(vertex, version.es ? version.Line() + "void main() {}\n" : "", {});
    AddMesh(program.Attributes(), inputs);
  }
  const DrawnImage image = Draw(vertex, inputs, options.image);
  if (!options.png.empty()) harness::WritePng(options.png, ColorsOf(image));

  constexpr double kDepthError = 1e-5;
  const Difference difference = Compare(image, options.expectation);
  const bool right = difference.missing == 0 && difference.extra == 0 &&
                     (options.any_depth || difference.depth_error < kDepthError);
  std::printf("%d of %zu pixels drawn: %d missing, %d too many, largest depth error %.2g\n",
              difference.drawn, image.pixels.size(), difference.missing, difference.extra,
              difference.depth_error);
  return right ? 0 : 1;
}

int RunPair(const Arguments& arguments) {
  const std::vector<std::string> paths = Parse(arguments, {});
  if (paths.size() != 4)
    throw DrawError("pair takes four files: two vertex shaders, each with its fragment shader");
  std::vector<std::string> texts;
  for (const std::string& path : paths) texts.push_back(ReadFile(path));
  PairDifference found;
  std::vector<std::string> messages;
  if (vulkan::IsSpirv(texts[0])) {
    std::vector<vulkan::Spirv> spirv;
    for (const std::string& text : texts) spirv.push_back(vulkan::SpirvOfBytes(text));
    vulkan::PairResult result = vulkan::CompareImages({spirv[0], spirv[1]}, {spirv[2], spirv[3]});
    found = result.difference;
    messages = std::move(result.messages);
  } else {
    const harness::OpenGl opengl(VersionOf(texts[0]).api);
    found = CompareImages({texts[0], texts[1]}, {texts[2], texts[3]});
  }
  std::printf("%d of %d pixels drawn in %d colors, %d different\n", found.drawn, found.pixels,
              found.colors, found.different);
  for (const std::string& message : messages)
    std::printf("the validation layers say: %s\n", message.c_str());
  // An image with less in it would show nothing. An edge may fall to either side of a pixel.
  const bool shows = 4 * found.drawn > found.pixels && found.colors > 64;
  if (!shows) std::printf("the image shows too little\n");
  return shows && messages.empty() && 200 * found.different < found.pixels ? 0 : 1;
}

int RunLink(const Arguments& arguments) {
  const std::vector<std::string> paths = Parse(arguments, {});
  if (paths.empty() || paths.size() % 2 != 0)
    throw DrawError("link takes vertex shaders, each with its fragment shader after it");
  std::vector<std::string> texts;
  for (const std::string& path : paths) texts.push_back(ReadFile(path));
  const std::vector<std::string> said =
      vulkan::IsSpirv(texts[0]) ? LinkOnVulkan(texts) : LinkOnOpenGl(texts);
  std::size_t refused = 0;
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (said[i].empty()) continue;
    std::printf("%s %s: %s\n", paths[2 * i].c_str(), paths[2 * i + 1].c_str(), said[i].c_str());
    ++refused;
  }
  std::printf("%zu of %zu programs link\n", paths.size() / 2 - refused, paths.size() / 2);
  return refused == 0 ? 0 : 1;
}

int RunPasses(const Arguments& arguments) {
  const std::vector<std::string> paths = Parse(arguments, {});
  if (paths.size() != 2) throw DrawError("passes takes two vertex shaders");
  const harness::OpenGl opengl(harness::Api::kCore);
  const PassesDifference found = ComparePasses(ReadFile(paths[0]), ReadFile(paths[1]));
  std::printf("%d of %d pixels of the first pass are missing in the second\n", found.missing,
              found.drawn);
  return found.drawn > 0 && found.missing == 0 ? 0 : 1;
}

int RunMachineCode(const Arguments& arguments) try {
  const vulkan::CodeCounter counter;
  int status = 0;
  for (const std::string& path : Parse(arguments, {})) try {
      const vulkan::MachineCode code = counter.Count(vulkan::SpirvOfBytes(ReadFile(path)));
      std::printf("%s %ju %ju\n", path.c_str(), code.instructions, code.cycles);
    } catch (const DrawError& error) {
      std::fprintf(stderr, "%s: %s\n", path.c_str(), error.what());
      status = 2;
    }
  return status;
} catch (const vulkan::NoDevice& error) {
  std::fprintf(stderr, "clipc-draw: %s\n", error.what());
  return 77;
}

int RunDevices() {
  const harness::OpenGl opengl(harness::Api::kCore);
  std::printf("OpenGL: %s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  std::printf("Vulkan: %s\n", vulkan::Runner().name().c_str());
  std::printf("Vulkan with validation layers: %s\n", vulkan::PairDeviceName().c_str());
  return 0;
}

}  // namespace clipc::draw
