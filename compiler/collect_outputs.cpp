// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/collect_outputs.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "clip-table/write.h"
#include "compiler/depfile.h"
#include "compiler/facts_json.h"
#include "compiler/list_spirv.h"
#include "compiler/output_files.h"
#include "compiler/structs.h"

namespace clipc {
namespace {

std::string VariableOf(const CommandLine& command, const CompileResult& result) {
  if (!command.variable.empty()) return command.variable;
  std::string name = "g_" + result.table->entry;
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

void AddShaders(const CommandLine& command, const Outputs& outputs, CompileResult& result,
                std::vector<OutputPiece>& pieces) {
  const bool is_pair = command.request.link.is_pair;
  const bool is_spirv = command.request.outputs.spirv.has_value();
  if (is_spirv) {
    pieces.push_back({"spirv", outputs.glsl, ContentsOf(result.spirv, command.spirv_form)});
  } else if (!command.request.planes.variants) {
    pieces.push_back({"glsl", outputs.glsl, std::move(result.shaders.vertex)});
  }
  if (is_spirv && is_pair) {
    pieces.push_back(
        {"fragment.spirv", outputs.fragment, ContentsOf(result.pixel_spirv, command.spirv_form)});
  } else if (!command.request.planes.variants && !outputs.fragment.empty()) {
    pieces.push_back({"fragment", outputs.fragment, std::move(result.shaders.fragment)});
  }
  for (std::size_t planes = 0; planes < result.variants.size(); ++planes) {
    const std::string path = VariantName(outputs.glsl, planes);
    pieces.push_back(
        {fmt::format("glsl.{}", planes), path, std::move(result.variants[planes].vertex)});
    if (outputs.fragment.empty()) continue;
    const std::string stem = WithoutExtension(outputs.glsl);
    const std::string fragment =
        is_pair ? VariantName(outputs.fragment, planes)
                : WithoutExtension(path) + outputs.fragment.substr(stem.size());
    pieces.push_back({fmt::format("fragment.{}", planes), fragment,
                      std::move(result.variants[planes].fragment)});
  }
}

}  // namespace

std::string CollectOutputs(const CommandLine& command, const Outputs& outputs,
                           CompileResult& result, std::vector<OutputPiece>& pieces) {
  FileSet sources;
  for (const std::string& source : result.dependencies) sources.Add(source);
  for (const std::string& path : outputs.Named()) {
    if (sources.Has(path))
      return fmt::format("the output `{}` would overwrite an included file", path);
  }
  const CompileRequest& request = command.request;
  if (!result.dump.empty()) pieces.push_back({"dump", "-", result.dump});
  if (result.ok() && !outputs.preprocessed.empty())
    pieces.push_back({"preprocessed", outputs.preprocessed, result.preprocessed});
  if (result.hlsl && !outputs.glsl.empty())
    pieces.push_back({"hlsl", outputs.glsl, std::move(*result.hlsl)});
  if (result.hlsl && !outputs.fragment.empty())
    pieces.push_back({"fragment.hlsl", outputs.fragment, std::move(result.shaders.fragment)});
  const bool is_complete = result.table.has_value() && !request.debug.dump;
  std::string header;
  if (is_complete && !outputs.header.empty()) {
    const std::string variable = VariableOf(command, result);
    header = request.outputs.spirv ? HeaderWith(result.spirv, variable)
                                   : HeaderWith(result.shaders.vertex, variable);
    if (request.link.is_pair)
      header += request.outputs.spirv ? HeaderWith(result.pixel_spirv, variable + "_pixel")
                                      : HeaderWith(result.shaders.fragment, variable + "_pixel");
  }
  if (is_complete && !outputs.glsl.empty()) AddShaders(command, outputs, result, pieces);
  if (!header.empty()) pieces.push_back({"header", outputs.header, std::move(header)});
  if (is_complete && !outputs.listing.empty())
    pieces.push_back({"listing", outputs.listing, result.listing});
  for (std::size_t i = 0; is_complete && i < outputs.tables.size(); ++i) {
    const std::string& path = outputs.tables[i];
    auto text = clip_table::Write(*result.table, *clip_table::FormatOf(path), path);
    if (!text) return fmt::format("cannot write `{}`: {}", path, text.error);
    pieces.push_back({Numbered("table", i), path, std::move(*text)});
  }
  for (std::size_t i = 0; is_complete && i < outputs.reflections.size(); ++i) {
    const std::string& path = outputs.reflections[i];
    pieces.push_back({Numbered("reflection", i), path,
                      path.ends_with(".h") ? WriteStructs(*result.facts, command.struct_prefix)
                                           : FactsJson(*result.facts)});
  }
  if ((is_complete || result.hlsl || request.outputs.preprocess) && result.ok() &&
      !outputs.dependencies.empty()) {
    pieces.push_back({"dependencies", outputs.dependencies,
                      DependencyRule(outputs.dependency_target, result.dependencies)});
  }
  return {};
}

}  // namespace clipc
