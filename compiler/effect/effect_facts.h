// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/stage.h"
#include "compiler/compile/facts.h"
#include "compiler/compile/result.h"
#include "compiler/effect/effect_choice.h"
#include "frontend/parse/effect.h"

// Everything that the host needs to draw with an effect, as values: its JSON (docs/effects.md) and
// its header for OpenGL are two ways to print them. States have values and places in the text.
namespace clipc {

// What a program of an effect is compiled to.
struct EffectCode {
  Facts facts;
  std::vector<ShaderOutput> shaders;
  friend bool operator==(const EffectCode&, const EffectCode&) = default;
};

struct EffectShaderFact {
  Stage stage = Stage::kVertex;
  std::string entry = {}, profile = {};
  std::string call = {};                    // with arguments; empty: it has none
  std::optional<std::size_t> element = {};  // of the array of shaders that the pass takes it from
};

// A part of what a program captures of its vertices: "0:TEXCOORD1.xy".
struct EffectCaptureFact {
  std::uint32_t stream = 0, slot = 0;
  std::string semantic = {};  // "$SKIP": nothing is written to these components
  std::uint32_t index = 0;
  std::string components = {};
  std::string name = {};  // of the variable in GLSL; empty: the program has none
};

struct EffectProgramFact {
  std::vector<EffectShaderFact> shaders = {};  // by stage, at least one
  std::vector<EffectCaptureFact> captures = {};
  bool is_compiled = false;
  std::vector<std::pair<std::string, std::string>> files = {};  // kind and name
  std::size_t number = 0;                       // the same for programs that are alike
  std::shared_ptr<const EffectCode> code = {};  // null: it is not compiled
};

struct EffectPassFact {
  ast::EffectPass text;
  bool is_left_out = false;  // it has a shader that clipc does not compile
  std::vector<EffectProgramFact> programs = {};
  std::vector<EffectChoice> choices = {};  // of the programs
};

struct EffectTechniqueFact {
  std::string kind = {}, group = {}, name = {};
  std::vector<ast::Annotation> annotations = {};
  std::vector<std::string> not_read = {};
  std::vector<EffectPassFact> passes = {};
};

struct EffectParameterFact {
  ast::EffectParameter text;
  std::vector<std::uint8_t> initial = {};  // the bytes of its value in a buffer; empty: none
};

struct EffectFacts {
  std::string effect = {};  // its file
  std::string target = {};
  bool has_files = true;       // its programs are in files, not in memory
  bool is_for_vulkan = false;  // its target is Vulkan's
  std::vector<EffectTechniqueFact> techniques = {};
  std::vector<EffectParameterFact> parameters = {};

  // The last parameter of the name; null: there is none.
  const EffectParameterFact* FindParameter(std::string_view name) const {
    for (std::size_t i = parameters.size(); i-- > 0;) {
      if (parameters[i].text.name == name) return &parameters[i];
    }
    return nullptr;
  }
};

}  // namespace clipc
