// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/semantic_check.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/spelling.h"

namespace clipc::signature {
namespace {

// The end of a message about a system value that the stage does not have: what compiles the stage
// that writes it, or the only one that reads it.
std::string AdviceFor(const SemanticName& semantic, Direction direction, const Program& program) {
  const bool is_of_points =
      direction == Direction::kPatchConstant &&
      LookUpSemantic(semantic.name, semantic.index, program.stage, Direction::kInput, false).use ==
          SystemValue::Use::kPlain;
  if (is_of_points) return "; a vertex shader has it, and may give it to the control points";
  if (direction == Direction::kPatchConstant) return {};
  const auto has = [&](const StageInfo& stage, Direction where) {
    const SystemValue value =
        LookUpSemantic(semantic.name, semantic.index, *StageOf(stage.prefix), where, false);
    return value.use == SystemValue::Use::kTarget || value.use == SystemValue::Use::kBuiltin;
  };
  const StageInfo* having = nullptr;
  for (const StageInfo& other : kStages) {
    const bool reads_constants = direction == Direction::kInput && other.reads_patches;
    if (!has(other, direction) && !(reads_constants && has(other, Direction::kPatchConstant)))
      continue;
    if (having && direction == Direction::kInput) return {};
    if (!having) having = &other;
  }
  return having ? CompiledBy(*having, program.profile) : "";
}

}  // namespace

SystemValue SemanticCheck::LookUp(const Carrier& leaf, Direction direction) {
  SystemValue value =
      LookUpSemantic(leaf.cursor.semantic.name, leaf.cursor.semantic.index, program_.stage,
                     direction, program_.profile.IsDirect3D9(), position_);
  const bool is_input = IsInput(direction, program_.stage);
  if (value.use == SystemValue::Use::kRefused) {
    const std::string_view near =
        NearSystemValue(leaf.cursor.semantic.name, program_.stage, direction);
    Diagnostic& report =
        diagnostics_.Report(leaf.span, diag::SemanticNotForStage, leaf.cursor.semantic.name,
                            is_input ? "input" : "output", InfoOf(program_.stage).name,
                            near.empty() ? AdviceFor(leaf.cursor.semantic, direction, program_)
                                         : fmt::format("; did you mean `{}`?", near));
    if (!near.empty()) report.Fix(leaf.span, std::string(near));
  } else if (!program_.is_interface_only && !program_.profile.IsAtLeast(value.major, value.minor)) {
    diagnostics_.Report(
        leaf.span, diag::ProfileNeededForSemantic, leaf.cursor.semantic.name,
        fmt::format("{}_{}_{}", InfoOf(program_.stage).prefix, value.major, value.minor),
        program_.profile.name);
  }
  return value;
}

bool SemanticCheck::MayAdd(const Carrier& leaf, Direction direction, const SystemValue& value) {
  if (IsDepth(value.builtin)) return IsFirstDepth(leaf);
  // The position has two names if Direct3D 9's name counts, and render targets have them.
  std::string name = value.builtin == Builtin::kPosition      ? "SV_POSITION"
                     : value.use == SystemValue::Use::kTarget ? "SV_TARGET"
                                                              : ToUpper(leaf.cursor.semantic.name);
  auto& seen = seen_[static_cast<std::size_t>(direction)];
  const bool is_input = IsInput(direction, program_.stage);
  const bool is_one = !is_input && value.use == SystemValue::Use::kBuiltin &&
                      value.builtin == Builtin::kPosition;  // whatever its index
  const std::uint32_t index = is_one ? 0 : leaf.cursor.semantic.index;
  const auto [found, is_new] =
      seen.try_emplace({std::move(name), index}, First{leaf.span, leaf.type});
  if (is_new || (is_input && program_.profile.IsDirect3D9())) return true;
  // Plain data can do no harm: each use becomes a variable of its own, as in glslang and in DXC's
  // SPIR-V. An output that the pipeline reads cannot have two values.
  const std::string_view side = is_input ? "inputs" : "outputs";
  const bool can_share = is_input || value.use == SystemValue::Use::kPlain;
  // Up to 5.1 pixel inputs of one type are one input, without a message: vkd3d's
  // entry-point-semantics.shader_test, line 279, checked against fxc and dxc.
  const bool is_pixel_input = is_input && InfoOf(program_.stage).has_stage_before;
  const bool is_dxc = is_pixel_input && program_.profile.IsAtLeast(6, 0);
  const bool is_builtin = value.use == SystemValue::Use::kBuiltin;
  if (is_pixel_input && !is_dxc && is_builtin && leaf.type == found->second.type) return true;
  const std::string how =
      fmt::format("{}; {}", is_pixel_input && !is_dxc ? ", with different types" : "",
                  is_builtin ? "" : "each use gets its own location, ");
  const std::string key = fmt::format("{}{}", found->first.first, found->first.second);
  (can_share ? diagnostics_.Report(leaf.span, diag::SemanticShared, key, side, how,
                                   is_dxc ? "dxc" : "fxc")
             : diagnostics_.Report(leaf.span, diag::SemanticTwice, key, side))
      .Note(found->second.span, diag::SemanticFirstUsed);
  return can_share;
}

bool SemanticCheck::IsFirstDepth(const Carrier& leaf) {
  const auto [found, is_new] = seen_[static_cast<std::size_t>(Direction::kOutput)].try_emplace(
      {"SV_DEPTH", 0}, First{leaf.span, leaf.type});
  if (is_new) return true;
  const SemanticName& semantic = leaf.cursor.semantic;
  const std::string number = semantic.index == 0 ? "" : std::to_string(semantic.index);
  diagnostics_
      .Report(leaf.span, diag::DepthTwice, fmt::format("`{}{}` writes", semantic.name, number))
      .Note(found->second.span, diag::SemanticFirstUsed);
  return false;
}

void SemanticCheck::Refuse(const Carrier& leaf, std::string_view wanted) {
  diagnostics_.Report(leaf.span, diag::SemanticType, leaf.cursor.semantic.name,
                      program_.types.Name(leaf.type), wanted);
}

bool SemanticCheck::Lacks(const Cursor& cursor, const SystemValue& value) const {
  const Profile& profile = program_.profile;
  const bool is_old_name = value.form != SystemValue::Form::kItself;
  if (value.use == SystemValue::Use::kBuiltin)
    return profile.level9 != Level9::kNone || (profile.major == 2 && is_old_name);
  return !cursor.assumed && LacksInput(profile, cursor.semantic);
}

bool SemanticCheck::IsTarget(const Carrier& leaf) {
  const std::uint32_t count = TargetsOf(program_.profile);
  if (leaf.cursor.semantic.index >= count) {
    diagnostics_.Report(leaf.span, diag::TooManyTargets, leaf.cursor.semantic.name,
                        leaf.cursor.semantic.index, count - 1);
    return false;
  }
  if (!IsWide(program_.types[leaf.type].scalar)) return true;
  Refuse(leaf, "a scalar or vector of `float`, `int` or `uint`");
  return false;
}

void SemanticCheck::CheckInterpolation(const Carrier& leaf) {
  const Cursor& cursor = leaf.cursor;
  const Profile& profile = program_.profile;
  const std::string_view modifier = cursor.sample     ? "sample"
                                    : cursor.centroid ? "centroid"
                                    : cursor.interpolation == Interpolation::kNoPerspective
                                        ? "noperspective"
                                    : cursor.interpolation == Interpolation::kLinear ? "linear"
                                                                                     : "";
  if (modifier.empty() || program_.is_interface_only) return;
  if (!IsFloat(program_.types[leaf.type].scalar)) {
    // dxc's rule META.INTEGERINTERPMODE; in Direct3D 9 inputs are floats in any case.
    if (profile.IsAtLeast(4, 0))
      diagnostics_.Report(leaf.span, diag::InterpolatedInteger, leaf.name, modifier);
  } else if (cursor.sample && !profile.IsAtLeast(4, 1)) {
    diagnostics_.Report(leaf.span, diag::QualifierProfile, "sample",
                        fmt::format("{}_4_1", InfoOf(program_.stage).prefix), profile.name);
  }
}

void SemanticCheck::CheckPosition(bool has_later_stage) {
  const IoVar* plain = FindPlainPosition(program_);
  if (!plain) return;
  const bool has_position = std::ranges::find(program_.outputs, Builtin::kPosition,
                                              &IoVar::builtin) != program_.outputs.end();
  const Span span = program_.vars[plain->var].span;
  if (position_ == PositionName::kStrict) {
    diagnostics_.Report(span, diag::PositionRefused, plain->semantic).Fix(span, "SV_Position");
  } else if (!has_position && !has_later_stage) {
    diagnostics_.Report(span, diag::PositionIsPlain, plain->semantic, program_.profile.name)
        .Fix(span, "SV_Position");
  }
}

}  // namespace clipc::signature
