// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <clipc/clipc.hpp>

// The pass in front of a compiler of HLSL that an application calls: docs/pass.md.
namespace clip_pass {

// The text of a file; nothing if there is none of that name.
using ReadFile = std::function<std::optional<std::string>(const std::string& path)>;

// A vertex shader and what it includes, which are in no file.
struct Shader {
  std::string path, entry;
  ReadFile read;
};

// Returns the text of the shader with its clip planes as clip distances. Its includes stay, for the
// compiler that follows. Throws std::runtime_error with clipc's messages.
inline std::string WithClipDistances(const Shader& shader) {
  clipc::library::Compiler compiler;  // one on each thread, for many shaders
  clipc::library::Request request;
  request.path = shader.path;
  request.text = shader.read(shader.path);
  request.options = {"--target=hlsl", "-E", shader.entry};
  request.read_include = shader.read;
  const clipc::library::Result result = compiler.Compile(request);
  if (!result.ok()) throw std::runtime_error(std::string(result.messages()));
  return std::string(result.hlsl());
}

// The shader of the examples.
inline Shader Water() {
  static const std::map<std::string, std::string, std::less<>> files = {
      {"water.hlsl",
       "#include \"planes.hlsli\"\n"
       "[clipplanes(water_plane)]\n"
       "float4 main(float4 position : POSITION) : SV_Position { return position; }\n"},
      {"planes.hlsli", "cbuffer Clip : register(b1) { float4 water_plane; };\n"}};
  return {"water.hlsl", "main", [](const std::string& path) -> std::optional<std::string> {
            const bool is_here = path.starts_with("./");
            const auto found = files.find(std::string_view(path).substr(is_here ? 2 : 0));
            if (found == files.end()) return std::nullopt;
            return found->second;
          }};
}

}  // namespace clip_pass
