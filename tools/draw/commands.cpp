// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/commands.h"

#include <bit>
#include <cstdio>
#include <map>

#include "tools/draw/arguments.h"
#include "tools/draw/options.h"
#include "tools/draw/picture.h"
#include "tools/draw/vulkan/run.h"

namespace clipc::draw {
namespace {

std::map<std::string, Flag> InputFlags(Inputs& inputs) {
  return {
      {"uniform", {true, [&](const std::string& value) { AddUniform(value, inputs); }}},
      {"block", {true, [&](const std::string& value) { AddBlock(value, inputs); }}},
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

// What --position and --constant give, with as many components as the shader declares.
void AddMesh(const std::vector<Active>& attributes, const std::string& position,
             const std::map<std::string, std::vector<std::uint32_t>>& constants, Inputs& inputs) {
  const std::vector<std::array<float, 4>> mesh = FullTarget();
  inputs.vertices = static_cast<int>(mesh.size());
  for (const Active& active : attributes) {
    const int components = ShapeOf(active.type).rows;
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
      {"position", {true, [&](const std::string& value) { options.position = value; }}},
      {"constant",
       {true,
        [&](const std::string& value) {
          const std::size_t at = std::min(value.find('='), value.size() - 1);
          options.constants[value.substr(0, at)] = ParseWords(value.substr(at + 1));
        }}},
      {"enable",
       {true, [&](const std::string& value) { options.picture.enable_mask = ParseNumber(value); }}},
      {"clip-plane",
       {true,
        [&](const std::string& value) {
          if (value.size() < 3 || value[0] < '0' || value[0] > '7' || value[1] != '=') {
            throw DrawError("--clip-plane 0=1,0,0,0, not `" + value + "`");
          }
          options.picture.clip_planes[value[0] - '0'] = ParsePlane(value.substr(2));
        }}},
      {"fragment",
       {true, [&](const std::string& value) { options.picture.fragment = ReadFile(value); }}},
      {"zero-to-one", {false, [&](const std::string&) { options.picture.zero_to_one = true; }}},
      {"expect-plane",
       {true,
        [&](const std::string& value) {
          options.expectation.planes.push_back(ParsePlane(value));
        }}},
      {"expect-flipped", {false, [&](const std::string&) { options.expectation.flipped = true; }}},
      {"expect-any-depth", {false, [&](const std::string&) { options.any_depth = true; }}},
      {"size",
       {true,
        [&](const std::string& value) {
          options.picture.size = static_cast<int>(ParseNumber(value));
        }}},
      {"png", {true, [&](const std::string& value) { options.png = value; }}},
  };
}

}  // namespace

int RunCapture(int argc, char** argv) {
  Inputs inputs;
  std::vector<std::string> outputs;
  std::map<std::string, Flag> flags = InputFlags(inputs);
  flags["attribute"] = {true, [&](const std::string& value) { AddAttribute(value, inputs); }};
  flags["output"] = {true, [&](const std::string& value) { outputs.push_back(value); }};
  const std::string vertex = ReadFile(OnlyPath(ParseOptions(argc, argv, flags)));
  if (outputs.empty()) {
    outputs.push_back("gl_Position");
    if (vertex.find("gl_ClipDistance[") != vertex.npos) outputs.push_back("gl_ClipDistance");
  }
  if (inputs.vertices == 0) inputs.vertices = 1;

  Device device;
  const Gl& gl = device.Use(VersionOf(vertex).api);
  const std::vector<Captured> captured = Capture(gl, vertex, outputs, inputs);
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

  Device device;
  const Version version = VersionOf(vertex);
  const Gl& gl = device.Use(version.api);
  {
    const Program program(gl, vertex, version.es ? version.Line() + "void main() {}\n" : "", {});
    AddMesh(program.Attributes(), options.position, options.constants, inputs);
  }
  const Picture picture = Draw(gl, vertex, inputs, options.picture);
  if (!options.png.empty()) WritePng(picture, options.png);

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
  Device device;
  std::printf("OpenGL: %s\n",
              reinterpret_cast<const char*>(device.Use(Api::kCore).GetString(GL_RENDERER)));
  std::printf("Vulkan: %s\n", vulkan::Runner().name().c_str());
  return 0;
}

}  // namespace clipc::draw
