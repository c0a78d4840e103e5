// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/command/place_outputs.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/file_set.h"
#include "base/path.h"
#include "base/spelling.h"
#include "base/stage.h"
#include "ir/profile.h"

namespace clipc {
namespace {

std::string FileName(const std::string& path) { return path.substr(NameBegin(path)); }

// Whether the value is only an extension, ".json", which names the file after another.
bool IsExtension(const std::string& value) {
  return value.size() > 1 && value[0] == '.' && !HasSlash(value);
}

// The files of an option that may be given several times, each once.
std::vector<std::string> NamesAfter(const std::vector<std::string>& values,
                                    const std::string& name) {
  std::vector<std::string> files;
  for (const std::string& value : values) {
    std::string file = NameAfter(value, name);
    if (std::ranges::find(files, file) == files.end()) files.push_back(std::move(file));
  }
  return files;
}

// The extension of the GLSL: that of a vertex shader where the profile is unknown, an error.
std::string_view GlslExtension(const ProgramRequest& request) {
  const auto profile = ir::ParseProfile(request.first().profile);
  return InfoOf(profile && profile->stage ? *profile->stage : Stage::kVertex).extension;
}

// The file of the input's shader in `place`, which may be a folder.
std::string InFolder(const std::string& place, const std::string& input,
                     std::string_view extension) {
  if (!EndsWithSlash(place) && (place == "-" || !IsDirectory(place))) return place;
  const std::string stem = input == "-" ? "stdin" : WithoutExtension(FileName(input));
  return fmt::format("{}{}{}{}", place, EndsWithSlash(place) ? "" : "/", stem, extension);
}

// The GLSL is written to standard output unless something else is asked for: the program or a dump
// takes standard output, and whoever names a header or a listing wants that.
std::string PlaceGlsl(const CommandLine& command, const std::string& input) {
  const std::string& output = command.output;
  const bool wants_other =
      command.request.debug.changes_result() || !command.header.empty() || !command.listing.empty();
  if (output.empty()) return wants_other ? "" : "-";
  return InFolder(output, input, ExtensionOf(command.request));
}

// The extension of a shader that is written beside the first one.
std::string StageExtension(const OutputOptions& outputs, Stage stage) {
  return fmt::format("{}{}", InfoOf(stage).extension, outputs.spirv ? ".spv" : "");
}

// The pixel shader of a pair. Named by an extension or a folder, it lies after or in that.
std::string PlacePixel(const CommandLine& command, const std::string& input,
                       const std::string& name) {
  const std::string& output = command.pixel_output;
  if (IsExtension(output)) return NameAfter(output, name);
  if (command.request.hlsl.wanted) {
    const std::string& path = command.pixel_shader.path;
    return InFolder(output, path.empty() ? input : path, ".hlsl");
  }
  return InFolder(output, input, StageExtension(command.request.outputs, Stage::kPixel));
}

}  // namespace

std::vector<std::string> OutputPaths::Named() const {
  std::vector<std::string> named;
  const auto add = [&](const std::string& path) {
    if (!path.empty() && path != "-") named.push_back(path);
  };
  add(glsl);
  std::ranges::for_each(middle, add);
  add(fragment);
  std::ranges::for_each(tables, add);
  std::ranges::for_each(reflections, add);
  for (const std::string& path : {dependencies, header, listing, preprocessed}) add(path);
  return named;
}

std::string_view ExtensionOf(const ProgramRequest& request) {
  return request.hlsl.wanted ? ".hlsl" : request.outputs.spirv ? ".spv" : GlslExtension(request);
}

std::string WithoutExtension(const std::string& path) {
  const std::size_t name = NameBegin(path);
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos || dot <= name ? path : path.substr(0, dot);
}

std::string VariantName(const std::string& path, std::size_t planes) {
  const std::string stem = WithoutExtension(path);
  return fmt::format("{}.{}{}", stem, planes, path.substr(stem.size()));
}

std::string NameAfter(const std::string& value, const std::string& name) {
  return IsExtension(value) ? WithoutExtension(name) + value : value;
}

// Places the files that are named after `name`, without the make rule.
static OutputPaths PlaceFiles(const CommandLine& command, const std::string& input,
                              const std::string& name) {
  OutputPaths outputs;
  outputs.header = NameAfter(command.header, name);
  outputs.listing = NameAfter(command.listing, name);
  outputs.tables = NamesAfter(command.tables, name);
  outputs.reflections = NamesAfter(command.reflections, name);
  for (std::size_t i = 0; i < command.middle.size(); ++i) {
    const std::string& output = command.middle[i].output;
    if (output.empty()) continue;
    outputs.middle[i] =
        IsExtension(output)
            ? NameAfter(output, name)
            : InFolder(output, input, StageExtension(command.request.outputs, kMiddleStages[i]));
  }
  if (!command.pixel_output.empty()) {
    outputs.fragment = PlacePixel(command, input, name);
  } else if (command.request.planes.lowering == Lowering::kDiscard &&
             !command.request.hlsl.wanted) {
    outputs.fragment =
        WithoutExtension(name) + (command.fragment.empty() ? ".discard.glsl" : ".frag");
  }
  return outputs;
}

// The targets of the make rule; `name` is that after which files are named.
static std::vector<std::string> TargetsOf(const CommandLine& command, const std::string& input,
                                          const std::string& name, const OutputPaths& outputs) {
  if (!command.dependency_target.empty()) return {command.dependency_target};
  const bool is_written = name != input && input != "-";
  std::vector<std::string> targets = {
      is_written ? name
                 : fmt::format("{}{}", WithoutExtension(name), GlslExtension(command.request))};
  for (const std::string& file : outputs.Named())
    if (file != targets.front()) targets.push_back(file);
  return targets;
}

OutputPaths PlaceOutputs(const CommandLine& command, const std::string& input) {
  if (command.syntax_only) return {};
  const std::string glsl = PlaceGlsl(command, input);
  // A file that is named after the GLSL is named after the first other file if the GLSL is written
  // to standard output, or else after the input.
  std::string name = input == "-" ? "stdin" : input;
  for (const std::string& file : {command.listing, command.header, glsl}) {
    if (!file.empty() && file != "-" && !IsExtension(file)) name = file;
  }
  OutputPaths outputs = PlaceFiles(command, input, name);
  outputs.glsl = glsl;
  std::vector<std::string> targets;
  if (command.only_dependencies || command.write_dependencies)
    targets = TargetsOf(command, input, name, outputs);
  const std::string preprocessed = NameAfter(command.preprocessed, name);
  if (command.only_dependencies || !preprocessed.empty()) outputs = {};
  outputs.dependency_targets = std::move(targets);
  const std::string rule = command.dependency_file.empty() ? ".d" : command.dependency_file;
  if (command.only_dependencies)
    outputs.dependencies = command.dependency_file.empty() ? "-" : NameAfter(rule, name);
  else if (command.write_dependencies)
    outputs.dependencies = NameAfter(rule, name);
  if (!command.only_dependencies) outputs.preprocessed = preprocessed;
  return outputs;
}

bool SaysOtherThanGlsl(std::string_view path) {
  constexpr std::string_view kCompiled[] = {".bin",  ".cso", ".dxbc", ".dxil", ".fx", ".fxo",
                                            ".hlsl", ".o",   ".obj",  ".spv",  ".vso"};
  const std::string lower = ToLower(path);
  return std::ranges::any_of(
      kCompiled, [&](std::string_view extension) { return lower.ends_with(extension); });
}

std::string WordsInC(std::span<const std::uint32_t> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += fmt::format("{}0x{:08x},", i % 8 == 0 ? "\n    " : " ", words[i]);
  return text;
}

std::string HeaderWith(std::span<const std::uint32_t> words, std::string_view variable) {
  return fmt::format(
      "// Written by clipc.\n#include <stdint.h>\nstatic const uint32_t {}[] = {{{}\n}};\n",
      variable, WordsInC(words));
}

std::string HeaderWith(std::string_view glsl, std::string_view variable) {
  std::string text = fmt::format("// Written by clipc.\nstatic const char {}[] =", variable);
  while (!glsl.empty()) {
    const std::size_t end = std::min(glsl.find('\n'), glsl.size() - 1) + 1;
    text += "\n    \"";
    for (const char c : glsl.substr(0, end)) {
      if (c == '"' || c == '\\') text += '\\';
      text += c == '\n' ? "\\n" : std::string(1, c);
    }
    text += '"';
    glsl.remove_prefix(end);
  }
  return text + ";\n";
}

}  // namespace clipc
