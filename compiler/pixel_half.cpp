// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/pixel_half.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "backend-glsl/names.h"
#include "frontend/lex/source_text.h"
#include "link/match.h"
#include "link/read.h"

namespace clipc {
namespace {

// The pixel profile beside the vertex profile, for what the pixel shader reads: ps_5_0 for vs_5_0.
// Limits of the hardware are not asked here, so ps_3_0 and ps_4_0 stand for the lower ones.
ir::Profile PixelProfile(const CompileRequest& request) {
  const ir::Profile vertex = *ir::ParseProfile(request.language.profile);
  const std::string name =
      vertex.IsDirect3D9() ? "ps_3_0" : fmt::format("ps_{}_{}", vertex.major, vertex.minor);
  return *ir::ParseProfile(name);
}

// The profile of a pixel shader that is compiled beside a vertex shader: of the same model, of
// ps_2_0 where there is none that clipc knows.
std::string PairedProfile(const std::string& vertex) {
  std::string name = vertex;
  name.replace(0, 2, "ps");
  const auto profile = ir::ParseProfile(name);
  return profile && profile->IsAtLeast(2, 0) ? name : "ps_2_0";
}

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

link::ReadResult ReadHlsl(const CompileRequest& request, SourceInput input,
                          std::vector<std::string>& dependencies) {
  link::ReadResult result;
  using Files = FrontendContext::Files;
  FrontendContext context(request.includes.read ? Files::kNone : Files::kOnDisk,
                          request.includes.sandbox);
  const std::string& entry = request.link.pixel_shader.entry;
  CheckOptions options = CheckOptions::For(PixelProfile(request), request.language.version);
  if (!entry.empty()) options.entry = entry;
  options.packing = request.language.packing;
  options.is_interface_only = true;
  options.stages_match_by_row = true;
  input.shader_model_major = options.profile.major;
  input.shader_model_minor = options.profile.minor;
  input.stage = Stage::kPixel;
  Source source(context, std::move(input));
  const auto place_of = [&](Span span) {
    const Place place = source.Resolve(span);
    return place.file.empty() ? request.link.pixel_shader.path
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

// Forgets names that the request knows better: those of HLSL and SPIR-V depend on what is made of
// them.
void ForgetNames(link::Interface& half, bool is_glsl) {
  for (link::Input& input : half.inputs) {
    if (!input.group && (input.location || !is_glsl)) input.name.clear();
  }
  for (link::UniformBlock& block : half.blocks) {
    if (!is_glsl) block.name.clear();
  }
}

link::ReadResult Read(const CompileRequest& request, SourceInput input,
                      std::vector<std::string>& dependencies) {
  const glsl::Target& target = request.target;
  const PixelShader& half = request.link.pixel_shader;
  std::string bytes;
  if (half.text) {
    bytes = *half.text;
  } else if (request.includes.read) {
    auto text = request.includes.read(half.path);
    if (!text) return {.problems = {fmt::format("{}: there is no such file", half.path)}};
    bytes = std::move(*text);
  } else {
    dependencies.push_back(half.path);
    if (const std::string problem = ReadText(half.path, bytes); !problem.empty())
      return {.problems = {fmt::format("{}: {}", half.path, problem)}};
  }
  const link::Language language = link::LanguageOf(bytes);
  if (language == link::Language::kSpirv) return link::ReadSpirv(bytes, half.path, half.entry);
  if (language == link::Language::kHlsl) {
    input.path = half.path;
    input.text = std::move(bytes);
    return ReadHlsl(request, std::move(input), dependencies);
  }
  const link::Dialect expected = target.IsVulkan() ? link::Dialect::kVulkan
                                 : target.IsEs()   ? link::Dialect::kEs
                                                   : link::Dialect::kDesktop;
  link::ReadResult result = link::ReadGlsl(bytes, half.path, expected);
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

}  // namespace

void LinkPixelShader(const CompileRequest& request, SourceInput input, ir::Program& program,
                     std::vector<std::string>& dependencies, Diagnostics& diagnostics) {
  const glsl::Target& target = request.target;
  link::ReadResult half = Read(request, std::move(input), dependencies);
  if (const std::string problem = link::Problem(half.interface); !problem.empty())
    half.problems.push_back(problem);
  for (const link::Group& group : half.interface.groups) {
    const bool is_known =
        target.Has(group.is_block ? glsl::Feature::kOutputBlocks : glsl::Feature::kInAndOut);
    if (!is_known) {
      half.problems.push_back(
          fmt::format("{}: `{}` is a {}; outputs of target `{}` cannot be in one", group.where,
                      group.type, group.is_block ? "block" : "struct", target.name()));
    }
  }
  if (!half.problems.empty()) {
    Diagnostic& report = diagnostics.Report({}, diag::PixelShader, half.problems.front());
    for (std::size_t i = 1; i < half.problems.size(); ++i)
      report.Note({}, diag::PlainNote, half.problems[i]);
    return;
  }
  // Drivers of desktop OpenGL link a program by name whose pixel shader reads what nothing writes.
  const bool links_by_name = !target.IsEs() && target.Has(glsl::Feature::kInAndOut) &&
                             !target.Has(glsl::Feature::kOutputLocations);
  const link::MatchOptions options{request.link.keep_outputs, target.IsVulkan(),
                                   request.link.zero_unwritten || links_by_name, target.IsEs()};
  const link::Matches matches = link::Match(program, half.interface, options, diagnostics);
  if (diagnostics.has_errors()) return;
  if (!request.style.names.empty()) ForgetNames(half.interface, half.is_glsl);
  link::Apply(program, half.interface, matches, options);
}

CompileRequest PixelRequest(const CompileRequest& request) {
  CompileRequest pixel = request;
  const PixelShader& half = request.link.pixel_shader;
  if (!half.path.empty()) {
    pixel.path = half.path;
    pixel.text = half.text;
    if (!half.text && request.includes.read) pixel.text = request.includes.read(half.path);
  }
  pixel.language.entry = half.entry.empty() ? "main" : half.entry;
  pixel.language.entry_call = half.entry_call;
  pixel.language.profile =
      half.profile.empty() ? PairedProfile(request.language.profile) : half.profile;
  // What only the vertex shader has.
  pixel.link = {};
  pixel.planes = {};
  pixel.target.bindings.pixel_base = 0;  // it is numbered together with the vertex shader
  pixel.style.invariant = false;
  pixel.debug = {};
  pixel.debug.dump_after = request.debug.dump_after;
  pixel.debug.verify = request.debug.verify;
  return pixel;
}

void NameInputs(ir::Program& pixel, const glsl::NameStyle& style) {
  glsl::Namer namer;
  for (ir::IoVar& input : pixel.inputs) {
    if (input.builtin != ir::Builtin::kNone) continue;
    ir::Reader& reader = input.reader.emplace();
    reader.is_known = false;
    reader.name = namer.Global(glsl::InterfaceName(input, style));
  }
}

void LinkPair(const CompileRequest& request, const Lowered& pixel, const Job& pixel_job,
              ir::Program& program, Diagnostics& diagnostics) {
  const auto place_of = [&](Span span) {
    const Place place = pixel_job.source.Resolve(span);
    return place.file.empty() ? pixel_job.request.path
                              : fmt::format("{}:{}:{}", place.file, place.line, place.column);
  };
  const link::Interface half = link::ReadInputs(pixel.program, place_of);
  // The pixel shader declares what it reads and nothing else, for Vulkan too.
  const link::MatchOptions options{.keep_outputs = request.link.keep_outputs,
                                   .zero_unwritten = request.link.zero_unwritten,
                                   .is_es = request.target.IsEs()};
  const link::Matches matches = link::Match(program, half, options, diagnostics);
  if (!diagnostics.has_errors()) link::Apply(program, half, matches, options);
}

void PlaceDistances(const ir::Program& vertex, const glsl::GlslInfo& info, ir::Program& pixel) {
  for (ir::IoVar& input : pixel.inputs) {
    if (input.semantic != ir::kClipPlaneDistance) continue;
    const auto output = std::ranges::find_if(vertex.outputs, [&](const ir::IoVar& candidate) {
      return candidate.semantic == input.semantic && candidate.index == input.index;
    });
    const auto number = static_cast<std::size_t>(output - vertex.outputs.begin());
    input.location = info.outputs[number].location.value_or(input.location);
    input.reader->name = info.outputs[number].name;
  }
}

}  // namespace clipc
