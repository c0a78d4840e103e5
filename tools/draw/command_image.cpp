// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <bit>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <nlohmann/json.hpp>

#include "tools/draw/commands.h"
#include "tools/draw/inputs.h"
#include "tools/draw/opengl/program.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/options.h"

namespace clipc::draw {
namespace {

using Json = nlohmann::json;

// The inputs of the draw. A sampler that the draw has no texture for reads black.
Inputs InputsOf(const Json& draw, const GlProgram& program) {
  Inputs inputs;
  inputs.vertices = draw.at("vertices");
  for (const auto& [name, words] : draw.at("attributes").items())
    inputs.attributes.push_back({name, words.get<Words>()});
  for (const auto& [name, words] : draw.at("uniforms").items())
    inputs.uniforms.push_back({name, words.get<Words>()});
  for (const auto& [name, words] : draw.at("blocks").items())
    inputs.blocks.push_back({name, BytesOf(words.get<Words>())});
  const Json textures = draw.value("textures", Json::object());
  for (const Active& uniform : program.Uniforms()) {
    if (FindLayout(uniform.type)) continue;
    Inputs::Texture& texture = inputs.textures.emplace_back();
    texture.name = uniform.name;
    texture.target = GL_TEXTURE_2D;
    Inputs::Texture::Level& level = texture.levels.emplace_back();
    if (textures.contains(uniform.name)) {
      const Json& given = textures.at(uniform.name);
      level.size = {given.at("width"), given.at("height"), 1};
      level.words = given.at("words").get<Words>();
    } else {
      level.words = {0, 0, 0, std::bit_cast<std::uint32_t>(1.0f)};
    }
  }
  return inputs;
}

// The colors, the bottom row first.
std::vector<float> ImageOf(const Json& draw) {
  GlProgram program(draw.at("vertex"), draw.at("fragment"), {});
  const bool is_reversed = draw.at("reversed");
  const harness::Framebuffer framebuffer(
      draw.at("width"), draw.at("height"),
      {draw.at("float") ? GLenum{GL_RGBA32F} : GLenum{GL_RGBA8}, GL_DEPTH_COMPONENT24});
  const auto clear = draw.at("clear").get<std::vector<float>>();
  glClearColor(clear.at(0), clear.at(1), clear.at(2), clear.at(3));
  glClearDepthf(is_reversed ? 0 : 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(is_reversed ? GL_GEQUAL : GL_LEQUAL);
  program.Bind(InputsOf(draw, program));
  const std::uint32_t distances = draw.at("clipDistances");
  for (int i = 0; i < 8; ++i) (distances >> i & 1 ? glEnable : glDisable)(GL_CLIP_DISTANCE0 + i);
  const auto indices = draw.at("indices").get<Words>();
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT,
                 indices.data());
  if (draw.at("float")) return framebuffer.ReadFloats(GL_RGBA);
  std::vector<float> colors;
  for (const std::uint8_t part : framebuffer.ReadUpsideDown().rgba)
    colors.push_back(static_cast<float>(part) / 255);
  return colors;
}

}  // namespace

int RunImage(const Arguments& arguments) {
  const std::vector<std::string> paths = harness::options::Parse(arguments, {});
  if (paths.size() != 2) throw DrawError("image takes a draw and the file for its colors");
  const Json draw = Json::parse(harness::ReadFile(paths[0]));
  const harness::OpenGl opengl(VersionOf(draw.at("vertex")).api);
  const std::vector<float> colors = ImageOf(draw);
  std::ofstream file(paths[1], std::ios::binary);
  file.write(reinterpret_cast<const char*>(colors.data()),
             static_cast<std::streamsize>(sizeof(float) * colors.size()));
  return file.flush() ? 0 : throw DrawError("cannot write `" + paths[1] + "`");
}

}  // namespace clipc::draw
