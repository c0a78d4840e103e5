// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "compiler/clipc.hpp"
#include "tools/values/script.h"

// A vertex and a pixel shader with the stages between them, or a compute shader, as clipc compiles
// them, and what its reflection says about them.
namespace clipc::values {

struct Input {  // of the vertex shader
  std::string semantic;
  std::uint32_t index = 0;
  std::uint32_t location = 0;
  bool is_integer = false;
};
struct ConstantBuffer {
  std::string block;         // in the GLSL
  std::uint32_t number = 0;  // 2 of b2
  std::uint32_t size = 0;
  // Where Direct3D 9 has each component of the buffer, whose registers are not packed.
  struct Component {
    std::uint32_t byte = 0;      // in the buffer
    std::uint32_t constant = 0;  // 6 of c1.z
    char kind = 'f';             // `i` of ints and `b` of bools, which are floats in Direct3D 9
  };
  std::vector<Component> components;
};
struct Object {
  std::string name;  // in the GLSL
  std::uint32_t binding = 0;
  std::uint32_t count = 1;   // elements of an array
  std::string type;          // "Texture2D<float4>"
  std::uint32_t number = 0;  // of t2, s2 or u2
  bool is_storage = false;   // u2
  bool compares = false;
  std::vector<std::uint32_t> samplers;  // the number of the sampler's register, or empty
};
struct CompiledPair {
  std::string vertex, pixel;                   // GLSL
  std::string compute;                         // or this one
  std::map<std::string, std::string> between;  // by the name of the stage: "geometry"
  std::vector<Input> inputs;
  std::vector<ConstantBuffer> buffers;
  std::vector<Object> objects;
  std::string refusal;  // clipc's messages; empty: it compiles
};

struct ShaderTexts {
  std::string vertex, pixel;
  std::map<std::string, std::string> between = {};  // by the name of the stage
  std::vector<std::string> options = {};

  bool operator==(const ShaderTexts&) const = default;
};

class PairCompiler {
 public:
  CompiledPair Compile(const ShaderTexts& texts, Model model);
  CompiledPair CompileCompute(const std::string& text, Model model,
                              const std::vector<std::string>& options);
  // The messages about one shader that has errors; empty: it compiles. `stage` is "vs" or "ps".
  std::string WhyRefused(const std::string& text, const std::string& stage, Model model,
                         const std::vector<std::string>& options);

 private:
  CompiledPair CompileProgram(const ShaderTexts& texts, Model model);

  library::Compiler compiler_;
};

}  // namespace clipc::values
