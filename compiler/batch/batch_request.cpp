// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/path.h"
#include "compiler/batch/batch.h"
#include "compiler/batch/manifest.h"
#include "compiler/command/place_outputs.h"
#include "compiler/command/show_messages.h"
#include "compiler/compile/token_digest.h"
#include "frontend/lex/source_text.h"

// The batch that a command line asks for: of its inputs, or of a manifest.
namespace clipc {
namespace {

// What stands for a request: the options but for those that change no output, and the manifest.
std::string IdentityOf(std::span<const char* const> arguments, const std::string& manifest) {
  std::vector<std::string> words = {CLIPC_VERSION};
  for (const std::string_view argument : arguments) {
    const bool changes_nothing =
        argument == "--resume" || argument == "-k" || argument.starts_with("-j");
    if (!changes_nothing) words.emplace_back(argument);
  }
  if (!manifest.empty()) {
    if (Result<std::string> text = ReadText(manifest)) words.push_back(std::move(*text));
  }
  const TokenDigest digest = DigestOf(words);
  return fmt::format("clipc {:016x}{:016x}", digest[0], digest[1]);
}

}  // namespace

bool WantsBatch(const CommandLine& command) {
  std::vector<std::string> defines = command.request.defines;
  return !command.batch.empty() || !TakeAxes(defines).empty();
}

RunResult RunBatch(std::span<const char* const> arguments, CommandLine command) {
  std::vector<ShaderGroup> groups;
  if (!command.batch.empty()) {
    if (!command.inputs.empty())
      return {Fail("the manifest of --batch names the shaders; give no others", command.format)};
    Result<std::vector<ShaderGroup>> manifest = ReadManifest(command.batch, arguments);
    if (!manifest) return {Fail(manifest.problem(), command.format)};
    groups = std::move(*manifest);
  } else if (command.inputs.empty()) {
    return {Fail("no input file; `clipc --help` lists the options", command.format)};
  }
  for (const std::string& input : command.inputs) {
    ShaderGroup group;
    group.command = command;
    group.axes = TakeAxes(group.command.request.defines);
    group.source = input;
    group.name = input == "-" ? "stdin" : WithoutExtension(input.substr(NameBegin(input)));
    groups.push_back(std::move(group));
  }
  std::string identity = IdentityOf(arguments, command.batch);
  const ShardOfIndex shard{command.shard, command.shards};
  return RunBatch(std::move(command),
                  {std::move(groups), {}, std::move(identity), [=](const auto& entries) {
                     return BatchEnd{RenderIndex(entries, shard)};
                   }});
}

}  // namespace clipc
