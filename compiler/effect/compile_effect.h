// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "compiler/command/command_line.h"
#include "compiler/compile/compile.h"
#include "compiler/compile/result.h"
#include "compiler/effect/effect_facts.h"

namespace clipc {

// What an effect becomes in memory.
struct CompiledEffect {
  // The status of the whole, and what the effect, its programs and its header say; what several
  // programs say is there once.
  CompileResult messages;
  std::optional<EffectFacts> facts;     // none: the effect is not read
  std::vector<CompileResult> programs;  // by EffectProgramFact::number
  std::string header;                   // where the command has a `header`
};

// Compiles the passes of an effect one after the other. The command's only input is its path; the
// text is that of the request, or of the file. The problem is one of the command.
Result<CompiledEffect> CompileEffect(CommandLine command, Compiler& compiler);

}  // namespace clipc
