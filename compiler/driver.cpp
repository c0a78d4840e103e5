// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/driver.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/file_set.h"
#include "base/path.h"
#include "base/result.h"
#include "base/system.h"
#include "compiler/batch/batch.h"
#include "compiler/batch/batch_index.h"
#include "compiler/command/collect_outputs.h"
#include "compiler/command/exit_code.h"
#include "compiler/command/in_order.h"
#include "compiler/command/options.h"
#include "compiler/command/output_files.h"
#include "compiler/command/place_outputs.h"
#include "compiler/command/show_messages.h"
#include "compiler/command/usage.h"
#include "compiler/compile/compile.h"
#include "compiler/compile/explain.h"
#include "compiler/compile/validate.h"
#include "compiler/effect/effect.h"
#include "compiler/watch.h"
#include "frontend/lex/source.h"
#include "frontend/lex/source_text.h"

namespace clipc {
namespace {

class Driver {
 public:
  explicit Driver(CommandLine&& command)
      : command_(std::move(command)), printer_(command_.format, command_.messages) {}

  RunResult Run();

 private:
  Result<> CheckUsage();
  int CompileAll();
  int Finish(CompileResult result, const OutputPaths& paths);
  Result<> Write(CompileResult& result, const OutputPaths& paths) const;
  void ShowNotices();

  CommandLine command_;
  std::vector<OutputPaths> outputs_;             // by input
  std::vector<std::vector<std::string>> files_;  // that were read, by input
  MessagePrinter printer_;
};

// What is wrong with a macro among the inputs, `A=1` that is not a file. A shell makes two words of
// -D A={0,1}.
Result<> CheckBraces(const CommandLine& command) {
  if (command.request.defines.empty()) return {};
  for (const std::string& input : command.inputs) {
    const std::size_t equals = input.find('=');
    std::error_code error;
    if (equals == 0 || equals == std::string::npos || std::filesystem::exists(input, error))
      continue;
    return Problem{fmt::format(
        "cannot read `{}`; a shell takes braces apart unless they are in quotes, -D '{}={{...}}'",
        input, input.substr(0, equals))};
  }
  return {};
}

// The first mistake that shows before anything is compiled.
Result<> Driver::CheckUsage() {
  const auto& inputs = command_.inputs;
  const ProgramRequest& request = command_.request;
  if (inputs.empty()) return Problem{"no input file; `clipc --help` lists the options"};
  const bool is_dump = request.debug.dump || !request.debug.stop_after.empty();
  const bool writes_glsl = !is_dump && !command_.only_dependencies && !command_.syntax_only &&
                           command_.preprocessed.empty();
  if (Result<> done = CheckBraces(command_); !done) return done;
  if (inputs.size() > 1 && writes_glsl && !IsDirectory(command_.output)) {
    return Problem{"several input files need a folder to write to; give an existing one with -o"};
  }
  if (request.planes.variants && !request.hlsl.wanted &&
      (command_.output.empty() || command_.output == "-")) {
    return Problem{"--variants writes several files, named after the one that -o gives"};
  }
  if (Result<> done = CheckCommand(command_); !done) return done;
  FileSet named, sources;
  for (const std::string& file : FilesRead(command_)) sources.Add(file);
  const std::string& messages = command_.messages;
  if (sources.Has(messages))
    return Problem{
        fmt::format("the messages in `{}` would overwrite a file that is read", messages)};
  if (!messages.empty() && messages != "-") named.Add(messages);
  for (const std::string& input : inputs) {
    for (const std::string& path : outputs_.emplace_back(PlaceOutputs(command_, input)).Named()) {
      if (named.Has(path))
        return Problem{fmt::format(
            "two outputs would go to `{}`; give them different names or extensions", path)};
      if (sources.Has(path))
        return Problem{fmt::format("the output `{}` would overwrite its input", path)};
      named.Add(path);
    }
    const bool is_binary =
        request.outputs.spirv && command_.spirv_form == CommandLine::SpirvForm::kBinary;
    if (writes_glsl && is_binary && outputs_.back().glsl == "-" && system::OutputIsOnTerminal())
      return Problem{"SPIR-V is not text; give a file with -o, or write it into a pipe"};
  }
  return {};
}

RunResult Driver::Run() {
  Result<> ready = CheckUsage();
  if (ready) ready = PrepareRequest(command_);
  if (!ready) return {Fail(ready.problem(), command_.format)};
  ShowNotices();
  int exit_code = command_.notices.has_errors() ? kExitUsage : CompileAll();
  std::vector<std::string> read = FilesRead(command_);
  for (const auto& files : files_) read.insert(read.end(), files.begin(), files.end());
  exit_code = printer_.End(exit_code, read);
  return {exit_code, std::move(files_)};
}

// Compiles on as many threads as were asked for. Messages and files come in the order of the
// inputs.
int Driver::CompileAll() {
  const std::size_t count = command_.inputs.size();
  int exit_code = kExitOk;
  std::size_t failed = 0;
  CompileInOrder(
      count, command_.jobs,
      [&](std::size_t index, Compiler& compiler) {
        ProgramRequest request = command_.request;
        ShaderSource& first = request.first();
        first.path = command_.inputs[index];
        // Several shaders read one text.
        if (first.path == "-" && request.shaders.size() > 1) {
          if (Result<std::string> text = ReadText("-")) first.text = std::move(*text);
        }
        return compiler.Compile(request);
      },
      [&](std::size_t index, CompileResult result) {
        files_.push_back(result.dependencies);
        const int code = Finish(std::move(result), outputs_[index]);
        exit_code = std::max(exit_code, code);
        failed += code == kExitOk ? 0 : 1;
        return true;
      });
  if (count > 1 && failed > 0) printer_.Say(fmt::format("{} of {} failed", failed, count));
  return exit_code;
}

int Driver::Finish(CompileResult result, const OutputPaths& paths) {
  for (const Include& include : result.includes) {
    if (command_.show_includes)
      fmt::print(stderr, "{} {}\n", std::string(include.depth, '.'), include.file);
  }
  printer_.Show(result);
  if (result.status == Status::kBadRequest) return kExitUsage;
  if (const Result<> written = Write(result, paths); !written)
    return printer_.Fail(written.problem());
  return result.ok() ? kExitOk : kExitErrors;
}

// Shows the warnings about the options and the names of the outputs.
void Driver::ShowNotices() {
  Diagnostics& notices = command_.notices;
  for (const OutputPaths& outputs : outputs_) {
    const bool is_glsl = !command_.request.outputs.spirv && !command_.request.hlsl.wanted;
    if (!is_glsl) continue;
    const auto check = [&](const std::string& path) {
      if (!path.empty() && SaysOtherThanGlsl(path)) notices.Report({}, diag::OutputNotGlsl, path);
    };
    check(outputs.glsl);
    std::ranges::for_each(outputs.middle, check);
    check(outputs.fragment);
  }
  ReportIdle(command_, notices);
  if (!notices.all().empty()) printer_.Show(NoticesOf(command_));
}

// Writes the outputs for one input.
Result<> Driver::Write(CompileResult& result, const OutputPaths& paths) const {
  Result<std::vector<OutputPiece>> pieces = CollectOutputs(command_, paths, result);
  if (!pieces) return Problem{pieces.problem()};
  OutputFiles files;
  for (OutputPiece& piece : *pieces) files.Add(std::move(piece.path), std::move(piece.contents));
  return files.Commit();
}

// Writes one index of those of all parts of a batch.
int MergeShards(const CommandLine& command) {
  if (command.inputs.empty())
    return Fail("--shard=merge needs the indexes of all parts, index.1-of-4.json and so on",
                command.format);
  Result<std::string> index = MergeIndexes(command.inputs);
  if (!index) return Fail(index.problem(), command.format);
  const std::string folder = command.inputs[0].substr(0, NameBegin(command.inputs[0]));
  OutputFiles files;
  const std::string path = command.index.empty() ? folder + "index.json" : command.index;
  FileSet read;
  for (const std::string& file : FilesRead(command)) read.Add(file);
  if (read.Has(path))
    return Fail(fmt::format("the output `{}` would overwrite its input", path), command.format);
  files.Add(path, std::move(*index));
  const Result<> written = files.Commit();
  return written ? kExitOk : Fail(written.problem(), command.format);
}

std::string VersionText(std::string_view commit) {
  const std::string part = commit.empty() ? "" : fmt::format("commit {}, ", commit);
  return fmt::format("clipc {}\n{}{}, {}\n", CLIPC_VERSION, part, LlvmName(), ValidatorName());
}

}  // namespace

int RunCommandLine(std::span<const char* const> arguments, std::string_view commit) {
  ParsedCommandLine parsed = ParseCommandLine(arguments);
  if (!parsed.result) return Fail(parsed.result.problem(), parsed.command.format);
  const auto run = [arguments](CommandLine command) {
    if (command.merge_shards) return RunResult{MergeShards(command)};
    if (command.effect) return RunEffect(std::move(command));
    if (WantsBatch(command)) return RunBatch(arguments, std::move(command));
    return Driver(std::move(command)).Run();
  };
  if (parsed.command.action == CommandLine::Action::kCompile) {
    if (parsed.command.watch) return WatchFiles(std::move(parsed.command), run);
    return run(std::move(parsed.command)).code;
  }
  OutputFiles files;
  std::string text;
  switch (parsed.command.action) {
    case CommandLine::Action::kExplain: text = Explain(parsed.command.explained); break;
    case CommandLine::Action::kVersion: text = VersionText(commit); break;
    default: text = HelpText(parsed.command.help_topic);
  }
  files.Add("-", std::move(text));
  const Result<> written = files.Commit();
  return written ? kExitOk : Fail(written.problem(), parsed.command.format);
}

}  // namespace clipc
