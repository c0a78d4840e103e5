// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/compile_effect.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "compiler/batch/batch_errors.h"
#include "compiler/effect/effect.h"
#include "compiler/effect/make_effect_facts.h"

namespace clipc {
namespace {

// Adds what a part of the effect says.
void AddMessages(const CompileResult& from, BatchErrors& seen, CompileResult& to) {
  if (seen.AreNew(from.messages)) {
    to.text += from.text;
    to.messages.insert(to.messages.end(), from.messages.begin(), from.messages.end());
  }
  for (const std::string& file : from.dependencies) {
    if (std::ranges::find(to.dependencies, file) == to.dependencies.end())
      to.dependencies.push_back(file);
  }
  if (to.status == Status::kOk || from.status == Status::kCancelled) to.status = from.status;
}

// Compiles the programs until one is cancelled. Returns their batch entries.
std::vector<BatchEntry> CompilePrograms(const std::vector<ShaderGroup>& groups, Compiler& compiler,
                                        BatchErrors& seen, CompiledEffect& made) {
  std::vector<BatchEntry> entries(groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    CompileResult& result = made.programs.emplace_back();
    if (made.messages.status == Status::kCancelled) continue;
    ProgramRequest request = groups[i].command.request;
    request.first().path = groups[i].source;
    result = compiler.Compile(request);
    entries[i].status = result.ok() ? BatchStatus::kCompiled : BatchStatus::kFailed;
    AddMessages(result, seen, made.messages);
  }
  return entries;
}

}  // namespace

Result<CompiledEffect> CompileEffect(CommandLine command, Compiler& compiler) {
  if (const Result<> usage = CheckEffectRequest(command); !usage) return Problem{usage.problem()};
  command.request.is_known = {};
  CompiledEffect made;
  LoadedEffect loaded = LoadEffect(command);
  command = loaded.command;
  if (loaded.is_read && !loaded.names)
    return Problem{fmt::format("`{}`: {}", command.inputs[0], loaded.names.problem())};
  BatchErrors seen;
  AddMessages(loaded.messages, seen, made.messages);
  if (!loaded.source->main_file_read()) made.messages.status = Status::kBadRequest;
  if (!loaded.is_read) return made;
  const std::vector<BatchEntry> entries =
      CompilePrograms(loaded.programs.groups, compiler, seen, made);
  std::vector<std::shared_ptr<const EffectCode>> code;
  for (const CompileResult& program : made.programs) {
    code.push_back(program.outputs ? std::make_shared<EffectCode>(EffectCode{
                                         *program.outputs->facts, program.outputs->shaders})
                                   : nullptr);
  }
  made.facts = MakeEffectFacts(loaded.effect, loaded.programs, command, entries, code);
  made.facts->has_files = false;
  EffectHeader header = MakeEffectHeader(*made.facts, *loaded.source, command);
  AddMessages(header.messages, seen, made.messages);
  made.header = std::move(header.text);
  return made;
}

}  // namespace clipc
