// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/neighbour.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "compiler/compile/plan.h"
#include "compiler/compile/stages.h"
#include "frontend/lex/source_text.h"
#include "link/read.h"

namespace clipc {
namespace {

// The program that is left of a typed pixel shader when the passes have removed what it does not
// need: what it then mentions is what it reads.
ir::Program Cleared(ir::Program program) {
  passes::PipelineOptions options;
  options.clip_planes.lowering = Lowering::kNone;
  passes::RunPipeline(program, options);
  return program;
}

// The message, with the option that names the pixel shader's entry function where that was not
// found.
std::string WithPixelEntry(const Diagnostic& diagnostic) {
  std::string message = diagnostic.message;
  if (diagnostic.id != DiagId::kEntryNotFound) return message;
  constexpr std::string_view kOption = "`-E` names";
  const std::size_t at = message.find(kOption);
  if (at == std::string::npos)
    return message + (message.ends_with('?') ? " " : "; ") + "`--pixel-entry` names it";
  return message.replace(at, kOption.size(), "`--pixel-entry` names");
}

link::ReadResult ReadHlsl(const ProgramRequest& request, std::string text,
                          std::vector<std::string>& dependencies) {
  link::ReadResult result;
  using Files = FrontendContext::Files;
  FrontendContext context(request.includes.read ? Files::kNone : Files::kOnDisk,
                          request.includes.sandbox);
  const CheckOptions options = NeighboursCheck(request);
  Source source(context, NeighboursInput(request, std::move(text), options));
  const auto place_of = [&](Span span) {
    const Place place = source.Resolve(span);
    return place.file.empty() ? request.neighbour->path
                              : fmt::format("{}:{}:{}", place.file, place.line, place.column);
  };
  Diagnostics diagnostics;
  const ast::File file = ReadFile(source, diagnostics);
  ir::Program program;
  if (!diagnostics.has_errors()) program = Check(file, options, diagnostics);
  for (std::string& path : source.Dependencies()) dependencies.push_back(std::move(path));
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == Severity::kError)
      result.problems.push_back(place_of(diagnostic.span) + ": " + WithPixelEntry(diagnostic));
  }
  if (result.problems.empty())
    result.interface = link::ReadProgram(Cleared(std::move(program)), place_of);
  return result;
}

link::ReadResult Read(const ProgramRequest& request, std::vector<std::string>& dependencies) {
  const glsl::Target& target = request.target;
  const Neighbour& given = *request.neighbour;
  std::string bytes;
  if (given.text) {
    bytes = *given.text;
  } else if (request.includes.read) {
    auto text = request.includes.read(given.path);
    if (!text) return {.problems = {fmt::format("{}: there is no such file", given.path)}};
    bytes = std::move(*text);
  } else {
    dependencies.push_back(given.path);
    Result<std::string> text = ReadText(given.path);
    if (!text) return {.problems = {fmt::format("{}: {}", given.path, text.problem())}};
    bytes = std::move(*text);
  }
  const link::Language language = link::LanguageOf(bytes);
  if (language == link::Language::kSpirv) {
    link::ReadResult result = link::ReadSpirv(bytes, given.path, given.entry);
    // The GLSL that becomes of it has the bindings that its target has.
    if (!target.IsVulkan() && !target.Has(glsl::Feature::kBindings)) {
      for (link::UniformBlock& block : result.interface.blocks) block.binding.reset();
    }
    return result;
  }
  if (language == link::Language::kHlsl) return ReadHlsl(request, std::move(bytes), dependencies);
  const link::Dialect expected = target.IsVulkan() ? link::Dialect::kVulkan
                                 : target.IsEs()   ? link::Dialect::kEs
                                                   : link::Dialect::kDesktop;
  link::ReadResult result = link::ReadGlsl(bytes, given.path, expected);
  for (const link::Input& input : result.interface.inputs) {
    const auto feature =
        input.group ? glsl::Feature::kBlockLocations : glsl::Feature::kOutputLocations;
    if (input.location && !target.Has(feature))
      result.problems.push_back(
          fmt::format("{}: `{}` has a location; outputs of target `{}` have none", input.where,
                      input.name, target.name()));
  }
  return result;
}

// Reports what the outputs of the target cannot be.
void CheckGroups(const glsl::Target& target, link::ReadResult& read) {
  for (const link::Group& group : read.interface.groups) {
    const bool is_known =
        target.Has(group.is_block ? glsl::Feature::kOutputBlocks : glsl::Feature::kInAndOut);
    if (!is_known) {
      read.problems.push_back(
          fmt::format("{}: `{}` is a {}; outputs of target `{}` cannot be in one", group.where,
                      group.type, group.is_block ? "block" : "struct", target.name()));
    }
  }
}

}  // namespace

link::ReadResult ReadNeighbour(const ProgramRequest& request,
                               std::vector<std::string>& dependencies) {
  link::ReadResult read = Read(request, dependencies);
  if (const std::string problem = link::Problem(read.interface); !problem.empty())
    read.problems.push_back(problem);
  CheckGroups(request.target, read);
  return read;
}

}  // namespace clipc
