// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/plan.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/file_set.h"
#include "base/spelling.h"
#include "compiler/compile/stages.h"
#include "compiler/compile/suggest.h"

namespace clipc {
namespace {

// The version of the SPIR-V that is made of the text, or that another compiler makes of its GLSL.
std::optional<unsigned> SpirvMinorOf(const ProgramRequest& request) {
  const bool is_for_vulkan = request.target.IsVulkan();
  if (!request.outputs.spirv && !is_for_vulkan) return std::nullopt;
  return request.outputs.spirv.value_or(SpirvRequest{}).MinorVersion(is_for_vulkan);
}

SourceInput InputOf(const ProgramRequest& request, std::string path,
                    std::optional<std::string> text, const ir::Profile& profile) {
  return {.path = std::move(path),
          .text = std::move(text),
          .include_dirs = request.includes.dirs,
          .defines = request.defines,
          .preamble = request.includes.preamble,
          .forced_includes = request.includes.forced,
          .read_include = request.includes.read,
          .shader_model_major = profile.major,
          .shader_model_minor = profile.minor,
          .spirv_minor = SpirvMinorOf(request),
          .stage = profile.stage.value_or(Stage::kVertex),
          .language = request.language.version,
          .pasted = profile.major < 6 || request.language.legacy_macro_expansion
                        ? PastedOperands::kExpanded
                        : PastedOperands::kKept,
          .max_bytes = request.limits.bytes,
          .max_tokens = request.limits.tokens,
          .record_macros = request.record_macros};
}

void ReportUnknown(const auto& kind, const std::string& name,
                   std::span<const std::string_view> names, Diagnostics& diagnostics) {
  diagnostics.Report({}, kind, name, Suggest(name, names));
}

// Reports an unknown profile, and the near ones of the stage that its first letter names.
void ReportUnknownProfile(const std::string& name, Diagnostics& diagnostics) {
  Stage stage = Stage::kVertex;
  for (const StageInfo& info : kStages) {
    if (ToLower(name).starts_with(info.prefix[0])) stage = *StageOf(info.prefix);
  }
  const std::vector<std::string> known = ir::ProfilesOf(stage);
  ReportUnknown(diag::UnknownProfile, name,
                std::vector<std::string_view>(known.begin(), known.end()), diagnostics);
}

// The profile of this name. None, with an error, if there is no such profile.
std::optional<ir::Profile> ProfileOf(const std::string& name, const LanguageOptions& language,
                                     Diagnostics& diagnostics) {
  std::optional<ir::Profile> profile = ir::ParseProfile(name);
  if (!profile) ReportUnknownProfile(name, diagnostics);
  if (!profile || profile->stage != Stage::kPixel || profile->major != 1) return profile;
  // fxc X3539; "Compiling Shaders" of Microsoft's HLSL guide has /Gec promote ps_1_x to ps_2_0.
  if (language.position_name != signature::PositionName::kBoth)
    diagnostics.Report({}, diag::ProfileRetired, profile->name);
  return ir::ParseProfile("ps_2_0");
}

CheckOptions CheckOptionsOf(const LanguageOptions& language, std::optional<ir::Profile> profile) {
  CheckOptions options;
  if (profile) options = CheckOptions::For(*std::move(profile), language.version);
  options.has_preshader = language.effect != 0;
  options.call_names_parameters = language.call_names_parameters;
  options.packing = language.packing;
  options.byte_matrices_by_row = language.byte_matrices_by_row;
  options.position_name = language.position_name;
  if (options.profile.stage && InfoOf(*options.profile.stage).draws_pixels)
    options.shadow_samplers = language.shadow_samplers;
  return options;
}

glsl::WriteOptions WriteOptionsOf(const StyleOptions& style, Diagnostics& diagnostics) {
  auto names = glsl::NameStyle::Parse(style.names.empty() ? "hlslcc" : style.names);
  if (!names) {
    ReportUnknown(diag::UnknownNames, style.names, glsl::NameStyle::Names(), diagnostics);
    names.emplace();
  }
  return {.separable = style.separable,
          .base_vertex_is_zero = style.base_vertex_is_zero,
          .base_instance_is_zero = style.base_instance_is_zero,
          .invariant = style.invariant,
          .relaxed_precision = style.relaxed_precision,
          .blocks = style.blocks,
          .names = std::move(*names)};
}

void CheckPassNames(const DebugOptions& debug, Diagnostics& diagnostics) {
  if (debug.dump_after.empty() && debug.stop_after.empty()) return;
  const std::vector<std::string_view> passes = PassNames();
  const auto check = [&](const std::string& name) {
    if (std::ranges::find(passes, name) == passes.end())
      ReportUnknown(diag::UnknownPass, name, passes, diagnostics);
  };
  std::ranges::for_each(debug.dump_after, check);
  if (!debug.stop_after.empty()) check(debug.stop_after);
}

// Reports options about planes and the next stage, which a program that begins with this profile
// cannot have.
void CheckStage(const ProgramRequest& request, const ir::Profile& profile,
                Diagnostics& diagnostics) {
  if (request.target.bindings.later_base && profile.stage &&
      !InfoOf(*profile.stage).has_stage_before) {
    diagnostics.Report({}, diag::OptionWithoutEffect, "--pixel-bindings",
                       request.shaders.size() > 1
                           ? fmt::format("the shaders of a {} are numbered together",
                                         request.shaders.size() > 2 ? "program" : "pair")
                           : fmt::format("this is a {} shader", InfoOf(*profile.stage).name));
  }
  if (profile.stage && InfoOf(*profile.stage).runs_in_groups && request.shaders.size() > 1)
    diagnostics.Report({}, diag::StageAlone, profile.name, InfoOf(*profile.stage).name);
  if (!profile.stage) return;
  // The positions of control points are not drawn.
  const bool is_alone = InfoOf(*profile.stage).makes_patches && request.shaders.size() == 1;
  if (InfoOf(*profile.stage).has_stage_after && !is_alone) return;
  const auto refuse = [&](bool is_given, std::string_view option) {
    if (is_given)
      diagnostics.Report({}, diag::OptionOfStage, option, profile.name,
                         InfoOf(*profile.stage).name);
  };
  refuse(request.is_linked(), "--pixel-shader");
  refuse(request.planes.fragment.has_value(), "--fragment");
  refuse(request.planes.variants.has_value(), "--variants");
  refuse(request.planes.lowering.has_value(), "--lower");
  refuse(request.planes.space != PlaneSpace::kClip, "--plane-space");
  refuse(request.style.invariant && !is_alone, "--invariant");
}

// Reports a stage that the host of the rules for bindings does not have.
void CheckBindingsHave(const glsl::BindingRules& rules, const ir::Profile& profile,
                       Diagnostics& diagnostics) {
  if (profile.stage && !rules.stages.empty() &&
      std::ranges::find(rules.stages, *profile.stage) == rules.stages.end())
    diagnostics.Report({}, diag::BindingsOfStage, rules.host, InfoOf(*profile.stage).name);
}

// Reports planes in the space of the positions that a vertex shader reads, in a stage after it.
void CheckPlaneSpace(const ProgramRequest& request, std::size_t number, const Plan& plan,
                     Diagnostics& diagnostics) {
  const ir::Profile& profile = plan.check.profile;
  const bool has_vertices = profile.stage && InfoOf(*profile.stage).reads_vertices &&
                            (number > 0 || !InfoOf(*profile.stage).makes_patches);
  if (has_vertices && number == request.PlaneStage() && request.planes.space == PlaneSpace::kObject)
    diagnostics.Report({}, diag::PlaneSpaceOfStage, profile.name, InfoOf(*profile.stage).name);
}

// The clip planes as the request has them for a shader. One before the last that has them gives
// them to that, or Fit reports them.
LoweringRequest LoweringOf(const ProgramRequest& request, std::size_t number,
                           const ir::Profile& profile) {
  const std::size_t owner = request.PlaneStage();
  static const PlaneOptions kNone;
  const PlaneOptions& planes = number == owner ? request.planes : kNone;
  const Lowering usual = number < owner ? Lowering::kNone : DefaultLowering(profile);
  return {planes.lowering.value_or(usual), planes.space, planes.position_input,
          request.hlsl.plane_distances};
}

// The profile of a pixel shader beside that of a vertex shader, for what the pixel shader reads:
// ps_5_0 for vs_5_0. Limits of the hardware are not asked here, so ps_3_0 and ps_4_0 stand for the
// lower ones.
ir::Profile NeighboursProfile(const ir::Profile& vertex) {
  const std::string name =
      vertex.IsDirect3D9() ? "ps_3_0" : fmt::format("ps_{}_{}", vertex.major, vertex.minor);
  return *ir::ParseProfile(name);
}

// Reports what is wrong with the request as a whole; `plan` is that of its first shader.
void CheckProgram(const ProgramRequest& request, const Plan& plan, Diagnostics& diagnostics) {
  CheckPassNames(request.debug, diagnostics);
  CheckRequest(plan.lowering, diagnostics);
  if (request.hlsl.wanted) CheckHlslRequest(plan.lowering, diagnostics);
  if (request.outputs.spirv && !request.target.Has(glsl::Feature::kSpirv)) {
    diagnostics.Report({}, diag::NoSpirv, request.target.name())
        .Note({}, diag::TargetNearest, request.target.NearestWith(glsl::Feature::kSpirv));
  }
  CheckStage(request, plan.check.profile, diagnostics);
  if (!request.includes.sandbox.empty() && !IsDirectory(request.includes.sandbox))
    diagnostics.Report({}, diag::NoSandbox, request.includes.sandbox);
}

// Reports what is wrong with a shader after the first.
void CheckNext(const ProgramRequest& request, std::size_t number, const Plan& plan,
               Diagnostics& diagnostics) {
  if (request.hlsl.wanted) CheckHlslRequest(plan.lowering, diagnostics);
  const ir::Profile& profile = plan.check.profile;
  const auto before = ir::ParseProfile(request.shaders[number - 1].profile);
  const bool is_after = profile.stage && before && before->stage &&
                        InfoOf(*before->stage).place < InfoOf(*profile.stage).place;
  if (!diagnostics.has_errors() && !is_after) {
    diagnostics.Report({}, diag::UnknownProfile, profile.name,
                       " of a pixel shader; `--pixel-profile` takes one such as `ps_5_0`");
  }
}

}  // namespace

std::size_t ProgramRequest::PlaneStage() const {
  for (std::size_t i = shaders.size(); i-- > 1;) {
    const auto profile = ir::ParseProfile(shaders[i].profile);
    if (profile && profile->stage && InfoOf(*profile->stage).has_stage_after) return i;
  }
  return 0;
}

Plan Resolve(const ProgramRequest& request, std::size_t number, Diagnostics& diagnostics) {
  const ShaderSource& shader = request.shaders[number];
  Plan plan;
  plan.check =
      CheckOptionsOf(request.language, ProfileOf(shader.profile, request.language, diagnostics));
  plan.check.keeps_bindings = request.target.KeepsBindings();
  plan.check.entry = shader.entry;
  plan.check.entry_call = shader.entry_call;
  const auto& stage = plan.check.profile.stage;
  if (request.planes.in_last_stage && number > 0 && number == request.PlaneStage() && stage &&
      !InfoOf(*stage).makes_patches)
    for (std::size_t i = 0; i < number; ++i)
      plan.check.planes_entries.push_back(request.shaders[i].entry);
  plan.write = WriteOptionsOf(request.style, diagnostics);
  plan.lowering = LoweringOf(request, number, plan.check.profile);
  if (number == 0) {
    plan.stop_after = request.debug.stop_after;
    CheckProgram(request, plan, diagnostics);
  } else {
    CheckNext(request, number, plan, diagnostics);
  }
  CheckPlaneSpace(request, number, plan, diagnostics);
  CheckBindingsHave(request.target.bindings, plan.check.profile, diagnostics);
  // HLSLcc, after fxc, has a variable for each column of a matrix between two stages. Its names
  // are the usual ones where stages match by name.
  const bool is_hlslcc = request.style.names.empty()
                             ? !request.target.Has(glsl::Feature::kOutputLocations)
                             : request.style.names == "hlslcc";
  plan.keeps_matrices_whole = !request.is_linked() && !is_hlslcc;
  // Of a pair, matrices match register by register, as in Direct3D.
  plan.check.stages_match_by_row = request.neighbour || plan.keeps_matrices_whole;
  plan.check.whole_register_planes = plan.lowering.lowering == Lowering::kLevel9;
  return plan;
}

SourceInput InputOf(const ProgramRequest& request, std::size_t number, const Plan& plan,
                    Diagnostics& diagnostics) {
  const ShaderSource& file = request.FileOf(number);
  std::optional<std::string> text = file.text;
  // The caller who gives the includes gives the text of every shader after the first too: no file
  // is read for it.
  if (&file != &request.first() && !text && request.includes.read) {
    text = request.includes.read(file.path);
    if (!text)
      diagnostics.Report({}, diag::PixelShader,
                         fmt::format("{}: there is no such file", file.path));
  }
  return InputOf(request, file.path, std::move(text), plan.check.profile);
}

CheckOptions NeighboursCheck(const ProgramRequest& request) {
  CheckOptions check = CheckOptionsOf(
      request.language, NeighboursProfile(*ir::ParseProfile(request.first().profile)));
  if (!request.neighbour->entry.empty()) check.entry = request.neighbour->entry;
  check.is_interface_only = true;
  check.stages_match_by_row = true;
  return check;
}

SourceInput NeighboursInput(const ProgramRequest& request, std::string text,
                            const CheckOptions& check) {
  return InputOf(request, request.neighbour->path, std::move(text), check.profile);
}

}  // namespace clipc
