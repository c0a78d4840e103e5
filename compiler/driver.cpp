// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/driver.h"

#include <algorithm>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "clip-table/write.h"
#include "compiler/compile.h"
#include "compiler/depfile.h"
#include "compiler/options.h"
#include "compiler/output_files.h"
#include "frontend/lex/source_text.h"

namespace clipc {
namespace {

int Fail(std::string_view what) {
  const std::string line = fmt::format("clipc: error: {}\n", what);
  std::fwrite(line.data(), 1, line.size(), stderr);
  return kExitUsage;
}

bool TerminalHasColour() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) && terminal && std::string_view(terminal) != "dumb" &&
         !std::getenv("NO_COLOR");
}

std::string WithoutExtension(const std::string& path) {
  const std::size_t name = path.rfind('/') + 1;  // npos + 1 is 0
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos || dot <= name ? path : path.substr(0, dot);
}

std::string FileName(const std::string& path) { return path.substr(path.rfind('/') + 1); }

// Where everything about one input goes. Empty: it was not asked for. "-": standard output.
struct Outputs {
  std::string glsl, fragment, table, reflection, dependencies;

  std::vector<std::string> Named() const {
    std::vector<std::string> named;
    for (const std::string& path : {glsl, fragment, table, reflection, dependencies}) {
      if (!path.empty() && path != "-") named.push_back(path);
    }
    return named;
  }
};

// "water.2.vert": the shader with two planes.
std::string VariantName(const std::string& path, std::size_t planes) {
  const std::string stem = WithoutExtension(path);
  return fmt::format("{}.{}{}", stem, planes, path.substr(stem.size()));
}

// A value that is only an extension, ".json", names the file after the GLSL.
std::string NameAfter(const std::string& value, const std::string& glsl) {
  const bool is_extension =
      value.size() > 1 && value[0] == '.' && value.find('/') == std::string::npos;
  return is_extension ? WithoutExtension(glsl) + value : value;
}

Outputs PlaceOutputs(const CommandLine& command, const std::string& input) {
  const bool is_folder =
      command.output.ends_with('/') || (command.output != "-" && IsDirectory(command.output));
  Outputs outputs;
  outputs.glsl = command.output.empty() ? "-" : command.output;
  if (is_folder) {
    const std::string stem = input == "-" ? "stdin" : WithoutExtension(FileName(input));
    outputs.glsl =
        fmt::format("{}{}{}.vert", command.output, command.output.ends_with('/') ? "" : "/", stem);
  }
  // What is named after the GLSL is named after the input when that goes to standard output.
  const std::string name = outputs.glsl != "-" ? outputs.glsl : input == "-" ? "stdin" : input;
  outputs.table = NameAfter(command.table, name);
  outputs.reflection = NameAfter(command.reflection, name);
  if (command.request.lowering == Lowering::kDiscard) {
    outputs.fragment =
        WithoutExtension(name) + (command.fragment.empty() ? ".discard.glsl" : ".frag");
  }
  if (command.write_dependencies) {
    outputs.dependencies =
        NameAfter(command.dependency_file.empty() ? ".d" : command.dependency_file, name);
  }
  // The program or a dump takes standard output; the GLSL is then written only where -o says.
  const DebugOptions& debug = command.request.debug;
  const bool is_dump = debug.dump || !debug.dump_after.empty() || !debug.stop_after.empty();
  if (is_dump && command.output.empty()) outputs.glsl.clear();
  return outputs;
}

class Driver {
 public:
  explicit Driver(CommandLine command) : command_(std::move(command)) {}

  int Run();

 private:
  std::string CheckUsage();
  int CompileAll();
  int Finish(const CompileResult& result, const Outputs& outputs);
  void AddShaders(const CompileResult& result, const Outputs& outputs, OutputFiles& files) const;
  std::string Write(const CompileResult& result, const Outputs& outputs);
  void Show(const CompileResult& result);

  CommandLine command_;
  std::vector<Message> messages_;  // of all inputs, for the formats that are one document
};

// What is wrong before anything is compiled; empty if nothing.
std::string Driver::CheckUsage() {
  const auto& inputs = command_.inputs;
  if (inputs.empty()) return "no input file; `clipc --help` lists the options";
  if (!command_.table.empty() && !clip_table::FormatOf(command_.table)) {
    return fmt::format("`{}` names no clip table; it ends in .json, .bin or .h", command_.table);
  }
  const bool is_dump = command_.request.debug.dump || !command_.request.debug.stop_after.empty();
  if (inputs.size() > 1 && !is_dump && !IsDirectory(command_.output)) {
    return "several input files need a folder to write to; give an existing one with -o";
  }
  if (command_.request.variants && (command_.output.empty() || command_.output == "-")) {
    return "--variants writes several files, named after the one that -o gives";
  }
  if (!command_.fragment.empty() && command_.request.lowering != Lowering::kDiscard) {
    return "--fragment is for --lower=discard; with the other lowerings the fragment shader stays "
           "as it is";
  }
  const CompileRequest& request = command_.request;
  if (!request.position_input.empty() && request.plane_space != PlaneSpace::kObject) {
    return "--position-input is for --plane-space=object; other spaces take the position that the "
           "shader computes";
  }
  FileSet named, sources;
  for (const std::string& input : inputs) sources.Add(input);
  if (!command_.fragment.empty()) sources.Add(command_.fragment);
  for (const std::string& input : inputs) {
    for (const std::string& path : PlaceOutputs(command_, input).Named()) {
      if (named.Has(path)) return fmt::format("two outputs would go to `{}`", path);
      if (sources.Has(path)) return fmt::format("the output `{}` would overwrite its input", path);
      named.Add(path);
    }
  }
  return {};
}

int Driver::Run() {
  if (const std::string problem = CheckUsage(); !problem.empty()) return Fail(problem);
  CompileRequest& request = command_.request;
  if (!command_.fragment.empty()) {
    const std::string problem = ReadText(command_.fragment, request.fragment.emplace());
    if (!problem.empty())
      return Fail(fmt::format("cannot read `{}`: {}", command_.fragment, problem));
  }
  request.reflect = !command_.reflection.empty();
  request.draw_text = command_.format == MessageFormat::kText;
  request.colour = request.draw_text && TerminalHasColour();
  const int exit_code = CompileAll();
  if (command_.format == MessageFormat::kJson || command_.format == MessageFormat::kSarif) {
    const std::string document =
        command_.format == MessageFormat::kJson ? RenderJson(messages_) : RenderSarif(messages_);
    std::fwrite(document.data(), 1, document.size(), stderr);
  }
  return exit_code;
}

// On as many threads as were asked for; what is said and written comes in the order of the inputs
// all the same.
int Driver::CompileAll() {
  const std::size_t count = command_.inputs.size();
  std::vector<std::optional<CompileResult>> results(count);
  std::mutex mutex;
  std::condition_variable done;
  std::size_t next = 0;
  const auto work = [&] {
    Compiler compiler;
    CompileRequest request = command_.request;
    for (std::unique_lock lock(mutex); next < count; done.notify_all()) {
      const std::size_t index = next++;
      lock.unlock();
      request.path = command_.inputs[index];
      CompileResult result = compiler.Compile(request);
      lock.lock();
      results[index] = std::move(result);
    }
  };
  std::vector<std::jthread> threads;
  if (const std::size_t jobs = std::min<std::size_t>(command_.jobs, count); jobs > 1) {
    for (std::size_t i = 0; i < jobs; ++i) threads.emplace_back(work);
  }
  Compiler compiler;
  int exit_code = kExitOk;
  for (std::size_t index = 0; index < count; ++index) {
    CompileResult result;
    if (threads.empty()) {
      command_.request.path = command_.inputs[index];
      result = compiler.Compile(command_.request);
    } else {
      std::unique_lock lock(mutex);
      done.wait(lock, [&] { return results[index].has_value(); });
      result = std::move(*results[index]);
      results[index].reset();
    }
    exit_code = std::max(exit_code, Finish(result, PlaceOutputs(command_, command_.inputs[index])));
  }
  return exit_code;
}

int Driver::Finish(const CompileResult& result, const Outputs& outputs) {
  Show(result);
  if (result.status == Status::kBadRequest) return kExitUsage;
  if (const std::string problem = Write(result, outputs); !problem.empty()) return Fail(problem);
  return result.ok() ? kExitOk : kExitErrors;
}

void Driver::Show(const CompileResult& result) {
  switch (command_.format) {
    case MessageFormat::kText:
      std::fwrite(result.text.data(), 1, result.text.size(), stderr);
      return;
    case MessageFormat::kMsvc: {
      const std::string lines = RenderMsvc(result.messages);
      std::fwrite(lines.data(), 1, lines.size(), stderr);
      return;
    }
    case MessageFormat::kJson:
    case MessageFormat::kSarif:
      messages_.insert(messages_.end(), result.messages.begin(), result.messages.end());
      return;
  }
}

void Driver::AddShaders(const CompileResult& result, const Outputs& outputs,
                        OutputFiles& files) const {
  if (!command_.request.variants) {
    files.Add(outputs.glsl, result.shaders.vertex);
    if (!outputs.fragment.empty()) files.Add(outputs.fragment, result.shaders.fragment);
  }
  for (std::size_t planes = 0; planes < result.variants.size(); ++planes) {
    const std::string path = VariantName(outputs.glsl, planes);
    files.Add(path, result.variants[planes].vertex);
    if (outputs.fragment.empty()) continue;
    const std::string ending = outputs.fragment.substr(WithoutExtension(outputs.glsl).size());
    files.Add(WithoutExtension(path) + ending, result.variants[planes].fragment);
  }
}

// Empty on success. A failed compile has no files, but perhaps a dump of a stage before the
// failure.
std::string Driver::Write(const CompileResult& result, const Outputs& outputs) {
  FileSet sources;
  for (const std::string& source : result.dependencies) sources.Add(source);
  for (const std::string& path : outputs.Named()) {
    if (sources.Has(path))
      return fmt::format("the output `{}` would overwrite an included file", path);
  }
  OutputFiles files;
  if (!result.dump.empty()) files.Add("-", result.dump);
  const bool is_complete = result.table.has_value() && !command_.request.debug.dump;
  if (is_complete && !outputs.glsl.empty()) AddShaders(result, outputs, files);
  if (is_complete && !outputs.table.empty()) {
    const auto format = clip_table::FormatOf(outputs.table);
    auto text = clip_table::Write(*result.table, *format, outputs.table);
    if (!text) return fmt::format("cannot write `{}`: {}", outputs.table, text.error);
    files.Add(outputs.table, std::move(*text));
  }
  if (is_complete && !outputs.reflection.empty()) files.Add(outputs.reflection, result.reflection);
  if (is_complete && !outputs.dependencies.empty()) {
    const std::string& target =
        !command_.dependency_target.empty() ? command_.dependency_target : outputs.glsl;
    files.Add(outputs.dependencies, DependencyRule(target, result.dependencies));
  }
  return files.Commit();
}

}  // namespace

int RunCommandLine(std::span<const char* const> arguments) {
  ParsedCommandLine parsed = ParseCommandLine(arguments);
  if (!parsed.error.empty()) return Fail(parsed.error);
  if (parsed.command.action == CommandLine::Action::kCompile)
    return Driver(std::move(parsed.command)).Run();
  OutputFiles files;
  files.Add("-", parsed.command.action == CommandLine::Action::kHelp ? HelpText()
                                                                     : "clipc " CLIPC_VERSION "\n");
  const std::string problem = files.Commit();
  return problem.empty() ? kExitOk : Fail(problem);
}

}  // namespace clipc
