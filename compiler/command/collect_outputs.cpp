// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/command/collect_outputs.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/file_set.h"
#include "clip-table/write.h"
#include "compiler/command/depfile.h"
#include "compiler/command/structs.h"
#include "compiler/compile/facts_json.h"
#include "compiler/compile/list_spirv.h"

namespace clipc {
namespace {

std::string VariableOf(const CommandLine& command) {
  if (!command.variable.empty()) return command.variable;
  std::string name = "g_" + command.request.first().entry;
  std::ranges::replace(name, ':', '_');
  return name;
}

// "table", "table.2": the kind of the first and of the second file of one option.
std::string Numbered(std::string_view kind, std::size_t number) {
  return number == 0 ? std::string(kind) : fmt::format("{}.{}", kind, number + 1);
}

std::string ContentsOf(const std::vector<std::uint32_t>& words, CommandLine::SpirvForm form) {
  using enum CommandLine::SpirvForm;
  if (form == kListing) return ListSpirv(words);
  if (form == kBinary) return {reinterpret_cast<const char*>(words.data()), 4 * words.size()};
  const std::string numbers = WordsInC(words);
  return form == kInBraces ? "{" + numbers + "\n}\n" : numbers.substr(1) + "\n";
}

// The piece of a shader as SPIR-V if it was compiled to that, else as text.
OutputPiece PieceOf(const CommandLine& command, std::string text_kind, std::string spirv_kind,
                    std::string path, ShaderOutput& shader) {
  if (shader.spirv.empty()) return {std::move(text_kind), std::move(path), std::move(shader.text)};
  return {std::move(spirv_kind), std::move(path), ContentsOf(shader.spirv, command.spirv_form)};
}

// Adds the shaders of a program, each if it has a path. `kinds` are those of their texts.
void AddShaders(const CommandLine& command, const OutputPaths& paths, const char* const (&kinds)[2],
                std::vector<ShaderOutput>& shaders, std::vector<OutputPiece>& pieces) {
  struct File {
    std::string text, spirv;
    const std::string& path;
  };
  std::vector<File> files = {{kinds[0], "spirv", paths.glsl}};
  for (std::size_t i = 0; i < command.middle.size(); ++i) {
    if (command.middle[i].output.empty()) continue;
    const std::string kind(InfoOf(kMiddleStages[i]).name);
    files.push_back({kind, kind + ".spirv", paths.middle[i]});
  }
  files.push_back({kinds[1], "fragment.spirv", paths.fragment});
  for (std::size_t i = 0; i < std::min(shaders.size(), files.size()); ++i) {
    const File& file = files[i];
    if (!file.path.empty())
      pieces.push_back(PieceOf(command, file.text, file.spirv, file.path, shaders[i]));
  }
}

void AddVariants(const CommandLine& command, const OutputPaths& paths,
                 std::vector<std::vector<ShaderOutput>>& variants,
                 std::vector<OutputPiece>& pieces) {
  for (std::size_t planes = 0; planes < variants.size(); ++planes) {
    std::vector<ShaderOutput>& shaders = variants[planes];
    const std::string path = VariantName(paths.glsl, planes);
    pieces.push_back(PieceOf(command, fmt::format("glsl.{}", planes),
                             fmt::format("spirv.{}", planes), path, shaders.front()));
    if (paths.fragment.empty()) continue;
    const std::string stem = WithoutExtension(paths.glsl);
    const std::string fragment = command.request.shaders.size() > 1
                                     ? VariantName(paths.fragment, planes)
                                     : WithoutExtension(path) + paths.fragment.substr(stem.size());
    pieces.push_back(PieceOf(command, fmt::format("fragment.{}", planes),
                             fmt::format("fragment.spirv.{}", planes), fragment, shaders[1]));
  }
}

// An array or a string with the shader of that number.
std::string HeaderOf(const Outputs& outputs, std::size_t shader, const std::string& variable) {
  const auto header_of = [](const ShaderOutput& output, const std::string& name) {
    return output.spirv.empty() ? HeaderWith(output.text, name) : HeaderWith(output.spirv, name);
  };
  if (outputs.variants.empty()) return header_of(outputs.shaders[shader], variable);
  std::string header, names, sizes;
  for (std::size_t planes = 0; planes < outputs.variants.size(); ++planes) {
    const std::string name = fmt::format("{}_{}", variable, planes);
    header += header_of(outputs.variants[planes][shader], name);
    names += (planes == 0 ? "" : ", ") + name;
    sizes += fmt::format("{}sizeof {}", planes == 0 ? "" : ", ", name);
  }
  const bool is_text = outputs.shaders[shader].spirv.empty();
  header += fmt::format("static const {}* const {}[] = {{{}}};  // by number of clip planes\n",
                        is_text ? "char" : "uint32_t", variable, names);
  if (!is_text)
    header +=
        fmt::format("static const unsigned {}_sizes[] = {{{}}};  // in bytes\n", variable, sizes);
  return header;
}

// The header of -Fh: an array or a string for each shader that was compiled, with variants for each
// of them and an array of these.
std::string HeaderOf(const CommandLine& command, const Outputs& outputs) {
  const std::string variable = VariableOf(command);
  std::string header = HeaderOf(outputs, 0, variable);
  const std::vector<ShaderSource>& shaders = command.request.shaders;
  for (std::size_t i = 1; i < shaders.size(); ++i) {
    const auto profile = ir::ParseProfile(shaders[i].profile);
    if (profile && profile->stage)
      header += HeaderOf(outputs, i, fmt::format("{}_{}", variable, InfoOf(*profile->stage).name));
  }
  return header;
}

// Adds the files that describe the program.
Result<> AddFacts(const CommandLine& command, const OutputPaths& paths, const Outputs& outputs,
                  std::vector<OutputPiece>& pieces) {
  if (!paths.listing.empty()) pieces.push_back({"listing", paths.listing, outputs.listing});
  for (std::size_t i = 0; i < paths.tables.size(); ++i) {
    const std::string& path = paths.tables[i];
    auto text = clip_table::Write(*outputs.table, *clip_table::FormatOf(path), path);
    if (!text) return Problem{fmt::format("cannot write `{}`: {}", path, text.error)};
    pieces.push_back({Numbered("table", i), path, std::move(*text)});
  }
  for (std::size_t i = 0; i < paths.reflections.size(); ++i) {
    const std::string& path = paths.reflections[i];
    pieces.push_back({Numbered("reflection", i), path,
                      path.ends_with(".h") ? WriteStructs(*outputs.facts, command.struct_prefix)
                                           : FactsJson(*outputs.facts)});
  }
  return {};
}

// Adds what was made of a program of GLSL.
Result<> AddGlsl(const CommandLine& command, const OutputPaths& paths, Outputs& outputs,
                 std::vector<OutputPiece>& pieces) {
  std::string header = paths.header.empty() ? "" : HeaderOf(command, outputs);
  if (!paths.glsl.empty() && command.request.planes.variants) {
    AddVariants(command, paths, outputs.variants, pieces);
  } else if (!paths.glsl.empty()) {
    AddShaders(command, paths, {"glsl", "fragment"}, outputs.shaders, pieces);
  }
  if (!header.empty()) pieces.push_back({"header", paths.header, std::move(header)});
  return AddFacts(command, paths, outputs, pieces);
}

}  // namespace

Result<std::vector<OutputPiece>> CollectOutputs(const CommandLine& command,
                                                const OutputPaths& paths, CompileResult& result) {
  FileSet sources;
  for (const std::string& source : result.dependencies) sources.Add(source);
  for (const std::string& path : paths.Named()) {
    if (sources.Has(path))
      return Problem{fmt::format("the output `{}` would overwrite an included file", path)};
  }
  std::vector<OutputPiece> pieces;
  const ProgramRequest& request = command.request;
  if (!result.dump.empty()) pieces.push_back({"dump", "-", result.dump});
  if (result.ok() && !paths.preprocessed.empty())
    pieces.push_back({"preprocessed", paths.preprocessed, result.preprocessed});
  const bool is_hlsl = result.outputs && request.hlsl.wanted;
  const bool is_glsl = result.outputs && !is_hlsl && !request.debug.dump;
  if (is_hlsl)
    AddShaders(command, paths, {"hlsl", "fragment.hlsl"}, result.outputs->shaders, pieces);
  if (is_glsl) {
    if (const Result<> done = AddGlsl(command, paths, *result.outputs, pieces); !done)
      return Problem{done.problem()};
  }
  if ((is_glsl || is_hlsl || request.outputs.preprocess) && result.ok() &&
      !paths.dependencies.empty()) {
    std::vector<std::string> targets = paths.dependency_targets;
    if (request.planes.variants && command.dependency_target.empty() && !pieces.empty()) {
      targets.clear();
      for (const OutputPiece& piece : pieces)
        if (piece.path != "-") targets.push_back(piece.path);
    }
    pieces.push_back(
        {"dependencies", paths.dependencies, DependencyRule(targets, result.dependencies)});
  }
  return pieces;
}

}  // namespace clipc
