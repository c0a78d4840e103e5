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
#include "compiler/place_outputs.h"
#include "frontend/lex/source.h"
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

class Driver {
 public:
  explicit Driver(CommandLine&& command) : command_(std::move(command)) {}

  int Run();

 private:
  std::string CheckUsage();
  int CompileAll();
  int Finish(CompileResult result, const Outputs& outputs);
  void AddShaders(CompileResult& result, const Outputs& outputs, OutputFiles& files) const;
  std::string Write(CompileResult& result, const Outputs& outputs);
  void Show(const CompileResult& result);
  void ShowNotices();
  std::string VariableOf(const CompileResult& result) const;

  CommandLine command_;
  std::vector<Outputs> outputs_;   // by input
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
  const bool writes_glsl = !is_dump && !command_.only_dependencies && !command_.syntax_only &&
                           command_.preprocessed.empty();
  if (inputs.size() > 1 && writes_glsl && !IsDirectory(command_.output)) {
    return "several input files need a folder to write to; give an existing one with -o";
  }
  if (command_.request.variants && (command_.output.empty() || command_.output == "-")) {
    return "--variants writes several files, named after the one that -o gives";
  }
  if (command_.request.variants && (!command_.header.empty() || command_.request.spirv))
    return "-Fh and -spirv write one shader; with --variants there are several";
  if (!command_.variable.empty() && command_.header.empty())
    return "-Vn names what -Fh writes; give that option too";
  if (!command_.fragment.empty() && command_.request.lowering != Lowering::kDiscard) {
    return "--fragment is for --lower=discard; with the other lowerings the fragment shader stays "
           "as it is";
  }
  const CompileRequest& request = command_.request;
  if (!request.position_input.empty() && request.plane_space != PlaneSpace::kObject) {
    return "--position-input is for --plane-space=object; other spaces take the position that the "
           "shader computes";
  }
  if (request.pixel_shader.path.empty() && request.keep_outputs) {
    return "--keep-outputs is for --pixel-shader; without it every output is kept";
  }
  FileSet named, sources;
  for (const std::string& input : inputs) sources.Add(input);
  if (!command_.fragment.empty()) sources.Add(command_.fragment);
  if (!request.pixel_shader.path.empty()) sources.Add(request.pixel_shader.path);
  for (const std::string& input : inputs) {
    for (const std::string& path : outputs_.emplace_back(PlaceOutputs(command_, input)).Named()) {
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
  request.list = !command_.listing.empty();
  request.preprocess = !command_.preprocessed.empty() || command_.only_dependencies;
  request.gives_planes_to_device = !command_.table.empty() || request.reflect;
  request.draw_text = command_.format == MessageFormat::kText;
  request.colour = request.draw_text && command_.colour.value_or(TerminalHasColour());
  ShowNotices();
  if (command_.notices.has_errors()) return kExitUsage;
  const int exit_code = CompileAll();
  if (command_.format == MessageFormat::kJson || command_.format == MessageFormat::kSarif) {
    const std::string document =
        command_.format == MessageFormat::kJson ? RenderJson(messages_) : RenderSarif(messages_);
    std::fwrite(document.data(), 1, document.size(), stderr);
  }
  return exit_code;
}

// Compiles on as many threads as were asked for. Messages and files come in the order of the
// inputs.
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
  std::size_t failed = 0;
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
    const int code = Finish(std::move(result), outputs_[index]);
    exit_code = std::max(exit_code, code);
    failed += code == kExitOk ? 0 : 1;
  }
  const bool is_text =
      command_.format == MessageFormat::kText || command_.format == MessageFormat::kMsvc;
  if (count > 1 && failed > 0 && is_text)
    fmt::print(stderr, "clipc: {} of {} failed\n", failed, count);
  return exit_code;
}

int Driver::Finish(CompileResult result, const Outputs& outputs) {
  for (const Include& include : result.includes) {
    if (command_.show_includes)
      fmt::print(stderr, "{} {}\n", std::string(include.depth, '.'), include.file);
  }
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

// Shows the warnings about the options and the names of the outputs.
void Driver::ShowNotices() {
  Diagnostics& notices = command_.notices;
  for (const Outputs& outputs : outputs_) {
    if (!command_.request.spirv && SaysOtherThanGlsl(outputs.glsl))
      notices.Report({}, diag::OutputNotGlsl, outputs.glsl);
  }
  if (notices.all().empty()) return;
  FrontendContext context;
  const Source nowhere(context, {});
  CompileResult result;
  result.text = nowhere.RenderText(notices, command_.request.colour);
  for (const Diagnostic& notice : notices.all())
    result.messages.push_back(ToMessage(notice, nowhere));
  Show(result);
}

std::string Driver::VariableOf(const CompileResult& result) const {
  if (!command_.variable.empty()) return command_.variable;
  std::string name = "g_" + result.table->entry;
  std::ranges::replace(name, ':', '_');
  return name;
}

void Driver::AddShaders(CompileResult& result, const Outputs& outputs, OutputFiles& files) const {
  if (!command_.request.variants) {
    const auto* const words = reinterpret_cast<const char*>(result.spirv.data());
    files.Add(outputs.glsl, command_.request.spirv ? std::string(words, 4 * result.spirv.size())
                                                   : std::move(result.shaders.vertex));
    if (!outputs.fragment.empty()) files.Add(outputs.fragment, std::move(result.shaders.fragment));
  }
  for (std::size_t planes = 0; planes < result.variants.size(); ++planes) {
    const std::string path = VariantName(outputs.glsl, planes);
    files.Add(path, std::move(result.variants[planes].vertex));
    if (outputs.fragment.empty()) continue;
    const std::string ending = outputs.fragment.substr(WithoutExtension(outputs.glsl).size());
    files.Add(WithoutExtension(path) + ending, std::move(result.variants[planes].fragment));
  }
}

// Returns an empty text on success. A failed compile has no files, but perhaps a dump of a stage
// before the failure. The texts are moved out of the result.
std::string Driver::Write(CompileResult& result, const Outputs& outputs) {
  FileSet sources;
  for (const std::string& source : result.dependencies) sources.Add(source);
  for (const std::string& path : outputs.Named()) {
    if (sources.Has(path))
      return fmt::format("the output `{}` would overwrite an included file", path);
  }
  OutputFiles files;
  if (!result.dump.empty()) files.Add("-", result.dump);
  if (result.ok() && !outputs.preprocessed.empty())
    files.Add(outputs.preprocessed, result.preprocessed);
  const bool is_complete = result.table.has_value() && !command_.request.debug.dump;
  std::string header;
  if (is_complete && !outputs.header.empty()) {
    const std::string variable = VariableOf(result);
    header = command_.request.spirv ? HeaderWith(result.spirv, variable)
                                    : HeaderWith(result.shaders.vertex, variable);
  }
  if (is_complete && !outputs.glsl.empty()) AddShaders(result, outputs, files);
  if (!header.empty()) files.Add(outputs.header, std::move(header));
  if (is_complete && !outputs.listing.empty()) files.Add(outputs.listing, result.listing);
  if (is_complete && !outputs.table.empty()) {
    const auto format = clip_table::FormatOf(outputs.table);
    auto text = clip_table::Write(*result.table, *format, outputs.table);
    if (!text) return fmt::format("cannot write `{}`: {}", outputs.table, text.error);
    files.Add(outputs.table, std::move(*text));
  }
  if (is_complete && !outputs.reflection.empty()) files.Add(outputs.reflection, result.reflection);
  if ((is_complete || command_.request.preprocess) && result.ok() &&
      !outputs.dependencies.empty()) {
    files.Add(outputs.dependencies, DependencyRule(outputs.dependency_target, result.dependencies));
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
