// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/plan.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/spelling.h"
#include "compiler/output_files.h"
#include "compiler/stages.h"
#include "compiler/suggest.h"

namespace clipc {
namespace {

SourceInput InputOf(const CompileRequest& request, const ir::Profile& profile) {
  return {.path = request.path,
          .text = request.text,
          .include_dirs = request.includes.dirs,
          .defines = request.defines,
          .preamble = request.includes.preamble,
          .forced_includes = request.includes.forced,
          .read_include = request.includes.read,
          .shader_model_major = profile.major,
          .shader_model_minor = profile.minor,
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
  const bool is_pixel = ToLower(name).starts_with('p');
  const std::vector<std::string> known = ir::ProfilesOf(is_pixel ? Stage::kPixel : Stage::kVertex);
  ReportUnknown(diag::UnknownProfile, name,
                std::vector<std::string_view>(known.begin(), known.end()), diagnostics);
}

CheckOptions CheckOptionsOf(const LanguageOptions& language, Diagnostics& diagnostics) {
  CheckOptions options;
  if (auto profile = ir::ParseProfile(language.profile)) {
    // fxc X3539; "Compiling Shaders" of Microsoft's HLSL guide has /Gec promote ps_1_x to ps_2_0.
    if (profile->stage == Stage::kPixel && profile->major == 1) {
      if (language.position_name != signature::PositionName::kBoth)
        diagnostics.Report({}, diag::ProfileRetired, profile->name);
      profile = ir::ParseProfile("ps_2_0");
    }
    options = CheckOptions::For(std::move(*profile), language.version);
  } else {
    ReportUnknownProfile(language.profile, diagnostics);
  }
  options.entry = language.entry;
  options.entry_call = language.entry_call;
  options.has_preshader = language.is_in_effect;
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

// Reports options about planes and the next stage, which a shader without one cannot have.
void CheckStage(const CompileRequest& request, const ir::Profile& profile,
                Diagnostics& diagnostics) {
  if (request.target.bindings.pixel_base && profile.stage && !InfoOf(*profile.stage).draws_pixels) {
    diagnostics.Report({}, diag::OptionWithoutEffect, "--pixel-bindings",
                       request.link.is_pair ? "the shaders of a pair are numbered together"
                                            : "this is not a pixel shader");
  }
  if (!profile.stage || InfoOf(*profile.stage).has_stage_after) return;
  const auto refuse = [&](bool is_given, std::string_view option) {
    if (is_given)
      diagnostics.Report({}, diag::OptionOfStage, option, profile.name,
                         InfoOf(*profile.stage).name);
  };
  refuse(request.link.has_pixel_shader(), "--pixel-shader");
  refuse(request.planes.fragment.has_value(), "--fragment");
  refuse(request.planes.variants.has_value(), "--variants");
  refuse(request.planes.lowering.has_value(), "--lower");
  refuse(request.planes.space != PlaneSpace::kClip, "--plane-space");
  refuse(request.style.invariant, "--invariant");
}

}  // namespace

Plan Resolve(const CompileRequest& request, Diagnostics& diagnostics) {
  Plan plan;
  const PlaneOptions& planes = request.planes;
  plan.check = CheckOptionsOf(request.language, diagnostics);
  plan.input = InputOf(request, plan.check.profile);
  plan.write = WriteOptionsOf(request.style, diagnostics);
  CheckPassNames(request.debug, diagnostics);
  plan.lowering = {planes.lowering.value_or(DefaultLowering(plan.check.profile)), planes.space,
                   planes.position_input, request.hlsl.plane_distances};
  CheckRequest(plan.lowering, diagnostics);
  if (request.hlsl.wanted) CheckHlslRequest(plan.lowering, diagnostics);
  CheckStage(request, plan.check.profile, diagnostics);
  if (!request.includes.sandbox.empty() && !IsDirectory(request.includes.sandbox))
    diagnostics.Report({}, diag::NoSandbox, request.includes.sandbox);
  // HLSLcc, after fxc, has a variable for each column of a matrix between two stages. Its names
  // are the usual ones where stages match by name.
  const bool is_hlslcc = request.style.names.empty()
                             ? !request.target.Has(glsl::Feature::kOutputLocations)
                             : request.style.names == "hlslcc";
  const bool has_pixel_shader = request.link.has_pixel_shader();
  plan.keeps_matrices_whole = !has_pixel_shader && !is_hlslcc;
  // Of a pair, matrices match register by register, as in Direct3D.
  plan.check.stages_match_by_row =
      (has_pixel_shader && !request.link.is_pair) || plan.keeps_matrices_whole;
  plan.check.whole_register_planes = plan.lowering.lowering == Lowering::kLevel9;
  return plan;
}

Plan ResolvePixelHalf(const CompileRequest& request, Diagnostics& diagnostics) {
  Plan plan = Resolve(request, diagnostics);
  plan.keeps_matrices_whole = plan.check.stages_match_by_row = false;
  const ir::Profile& profile = plan.check.profile;
  if (!diagnostics.has_errors() && profile.stage != Stage::kPixel)
    diagnostics.Report({}, diag::UnknownProfile, profile.name,
                       " of a pixel shader; `--pixel-profile` takes one such as `ps_5_0`");
  return plan;
}

}  // namespace clipc
