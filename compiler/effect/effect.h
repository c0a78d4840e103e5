// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "compiler/command/command_line.h"
#include "compiler/command/run_result.h"
#include "compiler/compile/result.h"
#include "compiler/effect/effect_facts.h"
#include "compiler/effect/effect_passes.h"

namespace clipc {

// An effect as the command line asks for it. Where the file is not read, only `messages` and `code`
// have a meaning.
struct LoadedEffect {
  bool is_read = false;
  Result<> names;       // whether there are a technique and a pass of the names that are asked for
  CommandLine command;  // with what the effect's dialect adds
  ast::File file;
  ast::Effect effect;
  EffectPrograms programs;  // they refer to `effect`
  CompileResult messages;
  std::unique_ptr<FrontendContext> context;
  std::unique_ptr<Source> source;  // of the places in `effect`
  int code = 0;                    // the exit code that the messages alone give
};

// Reads the effect of the command's input, or of the text of its request.
LoadedEffect LoadEffect(const CommandLine& command);

// The first mistake of the options, of those that a library has too.
Result<> CheckEffectRequest(const CommandLine& command);

// The header for OpenGL, where the command asks for it; and what it, or the JSON for Vulkan, leaves
// out of the effect's states. The text is empty where a warning about that is an error.
struct EffectHeader {
  std::string text;
  CompileResult messages;
};
EffectHeader MakeEffectHeader(const EffectFacts& facts, const Source& source,
                              const CommandLine& command);

// Runs --effect: compiles every pass of an effect as a pair or a single shader, and writes JSON
// that describes the effect beside them, and a header for OpenGL (docs/effects.md).
RunResult RunEffect(CommandLine command);

}  // namespace clipc
