// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/stage.h"
#include "compiler/batch/permutations.h"
#include "compiler/command/command_line.h"
#include "compiler/effect/effect_choice.h"
#include "frontend/parse/effect.h"

namespace clipc {

// A shader of a program.
struct EffectStage {
  Stage stage = Stage::kVertex;
  const ast::EffectShader* shader = nullptr;  // of kind kCompiled
  std::optional<std::size_t> element;         // of the array of shaders that the pass takes it from
  std::string profile;                        // that it is compiled for
};

struct EffectProgram {
  std::vector<EffectStage> shaders;  // by stage, at least one
  std::size_t group = 0;             // in EffectPrograms::groups; programs that are alike share one
  std::vector<std::string> captures =
      {};  // EffectShader::captures, of the last stage before pixels
};

struct PassPrograms {
  std::size_t technique = 0, pass = 0;  // in the effect
  bool is_left_out = false;             // it has a shader that clipc does not compile
  std::vector<EffectProgram> programs;  // several where the pass takes them from an array
  std::vector<EffectChoice> choices;    // what chooses them; none where nothing does
};

struct EffectPrograms {
  std::vector<PassPrograms> passes;  // those that the command line asks for
  std::vector<ShaderGroup> groups;   // what is compiled
};

// Finds the programs of the passes. Reports passes with shaders that clipc does not compile,
// shaders of another stage or of a function that `file` does not have, and text that is not
// understood.
EffectPrograms FindPrograms(const ast::File& file, const ast::Effect& effect,
                            const CommandLine& command, Diagnostics& diagnostics);

}  // namespace clipc
