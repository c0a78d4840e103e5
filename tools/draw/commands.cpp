// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/commands.h"

#include <bit>
#include <cstdio>
#include <map>

#include "tools/draw/arguments.h"
#include "tools/draw/opengl/picture.h"
#include "tools/draw/opengl/program.h"
#include "tools/draw/options.h"
#include "tools/draw/vulkan/run.h"

namespace clipc::draw {
namespace {

std::map<std::string, Flag> InputFlags(Inputs& inputs) {
  return {
      {"uniform", With([&](auto& value) { AddUniform(value, inputs); })},
      {"block", With([&](auto& value) { AddBlock(value, inputs); })},
  };
}

void Print(const Captured& output, int vertex) {
  const int size = output.shape.Words() * output.count;
  std::printf("%d %s =", vertex, output.name.c_str());
  for (int i = 0; i < size; ++i) {
    const std::uint32_t word = output.words[static_cast<std::size_t>(vertex) * size + i];
    switch (output.shape.kind) {
      case Shape::Kind::kFloat:
        std::printf(" %.9g", static_cast<double>(std::bit_cast<float>(word)));
        break;
      case Shape::Kind::kInt: std::printf(" %d", static_cast<std::int32_t>(word)); break;
      case Shape::Kind::kUint: std::printf(" %u", word); break;
    }
  }
  std::printf("\n");
}

// Adds the attributes of --position and --constant, with as many components as the shader declares.
void AddMesh(const std::vector<Active>& attributes, const std::string& position,
             const std::map<std::string, std::vector<std::uint32_t>>& constants, Inputs& inputs) {
  const std::vector<std::array<float, 4>> mesh = FullTarget();
  inputs.vertices = static_cast<int>(mesh.size());
  for (const Active& active : attributes) {
    const int components = ShapeOf(active).rows;
    Inputs::Attribute attribute{active.name, {}};
    const auto constant = constants.find(active.name);
    if (active.name != position && constant == constants.end()) continue;
    for (const auto& [x, y, z, w] : mesh) {
      std::vector<std::uint32_t> words;
      if (active.name == position) {
        const float divisor = components == 4 ? 1 : w;
        for (const float value : {x / divisor, y / divisor, z / divisor, w})
          words.push_back(std::bit_cast<std::uint32_t>(value));
      } else {
        words = constant->second;
      }
      words.resize(components);
      attribute.words.insert(attribute.words.end(), words.begin(), words.end());
    }
    inputs.attributes.push_back(std::move(attribute));
  }
}

struct PixelsOptions {
  std::string position = "in_POSITION0", png;
  std::map<std::string, std::vector<std::uint32_t>> constants;
  PictureOptions picture;
  Expectation expectation;
  bool any_depth = false;
};

std::map<std::string, Flag> PixelsFlags(PixelsOptions& options) {
  return {
      {"position", Text(options.position)},
      {"constant", With([&](auto& value) {
         const std::size_t at = std::min(value.find('='), value.size() - 1);
         options.constants[value.substr(0, at)] = ParseWords(value.substr(at + 1));
       })},
      {"enable", Number(options.picture.enable_mask)},
      {"clip-plane", With([&](auto& value) {
         if (value.size() < 3 || value[0] < '0' || value[0] > '7' || value[1] != '=') {
           throw DrawError("--clip-plane 0=1,0,0,0, not `" + value + "`");
         }
         options.picture.clip_planes[value[0] - '0'] = ParsePlane(value.substr(2));
       })},
      {"fragment", With([&](auto& value) { options.picture.fragment = ReadFile(value); })},
      {"zero-to-one", Switch(options.picture.zero_to_one)},
      {"expect-plane",
       With([&](auto& value) { options.expectation.planes.push_back(ParsePlane(value)); })},
      {"expect-flipped", Switch(options.expectation.flipped)},
      {"expect-any-depth", Switch(options.any_depth)},
      {"size", Number(options.picture.size)},
      {"png", Text(options.png)},
  };
}

}  // namespace

int RunCapture(int argc, char** argv) {
  Inputs inputs;
  std::vector<std::string> outputs;
  std::map<std::string, Flag> flags = InputFlags(inputs);
  flags["attribute"] = With([&](auto& value) { AddAttribute(value, inputs); });
  flags["output"] = Append(outputs);
  const std::string vertex = ReadFile(OnlyPath(ParseOptions(argc, argv, flags)));
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

int RunPixels(int argc, char** argv) {
  Inputs inputs;
  PixelsOptions options;
  std::map<std::string, Flag> flags = InputFlags(inputs);
  flags.merge(PixelsFlags(options));
  const std::string vertex = ReadFile(OnlyPath(ParseOptions(argc, argv, flags)));

  const Version version = VersionOf(vertex);
  const harness::OpenGl opengl(version.api);
  {
    const Program program(vertex, version.es ? version.Line() + "void main() {}\n" : "", {});
    AddMesh(program.Attributes(), options.position, options.constants, inputs);
  }
  const Picture picture = Draw(vertex, inputs, options.picture);
  if (!options.png.empty()) harness::WritePng(options.png, ColorsOf(picture));

  constexpr double kDepthError = 1e-5;
  const Difference difference = Compare(picture, options.expectation);
  const bool right = difference.missing == 0 && difference.extra == 0 &&
                     (options.any_depth || difference.depth_error < kDepthError);
  std::printf("%d of %zu pixels drawn: %d missing, %d too many, largest depth error %.2g\n",
              difference.drawn, picture.pixels.size(), difference.missing, difference.extra,
              difference.depth_error);
  return right ? 0 : 1;
}

int RunDevices() {
  const harness::OpenGl opengl(harness::Api::kCore);
  std::printf("OpenGL: %s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  std::printf("Vulkan: %s\n", vulkan::Runner().name().c_str());
  return 0;
}

}  // namespace clipc::draw
