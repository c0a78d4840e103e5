// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/interface_vars.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "base/spelling.h"
#include "frontend/signature/distances.h"

namespace clipc::signature {

// The inputs or outputs of most shaders.
constexpr std::size_t kUsualCount = 16;

InterfaceVars::InterfaceVars(Program& program, Diagnostics& diagnostics)
    : program_(program),
      stage_(InfoOf(program.stage)),
      diagnostics_(diagnostics),
      locations_{{"outputs", diagnostics}, {"inputs", diagnostics}},
      of_patch_{{"outputs", diagnostics}, {"inputs", diagnostics}} {}

VarId InterfaceVars::Add(IoVars& list, const Carrier& leaf, TypeId type, Builtin builtin) {
  const bool is_input = &list == &program_.inputs;
  const auto& [semantic, given, assumed, span, interpolation, centroid, sample, location,
               blend_index, precise] = leaf.cursor;
  std::string name(is_input ? "in" : stage_.prefix);
  name += '_';
  name += ToUpper(semantic.name);
  name += std::to_string(semantic.index);
  const VarId id = program_.vars.Add({.name = std::move(name),
                                      .type = type,
                                      .storage = is_input ? Storage::kInput : Storage::kOutput,
                                      .span = leaf.span,
                                      .precise = precise && !is_input});
  if (list.empty()) list.reserve(kUsualCount);
  std::string path = leaf.name + leaf.elements;
  std::uint32_t place = 0;
  // Only the inputs are read of a shader that another stage's must match.
  const bool is_matched = is_input || !program_.is_interface_only;
  const bool is_target = builtin == Builtin::kNone && !is_input && !stage_.has_stage_after;
  if (blend_index && !is_target)
    diagnostics_.Report(leaf.span, diag::AttributeWithoutEffect, "vk::index");
  if (is_target && is_matched)
    place = TargetNumber(leaf);
  else if (builtin == Builtin::kNone)
    place = (is_of_patch_ ? of_patch_ : locations_)[is_input].Next(
        is_matched ? location : std::nullopt, program_.types[type], path, leaf.span);
  list.push_back({id, semantic.name, semantic.index, builtin, place, interpolation, centroid,
                  sample, semantic.has_index, is_matched && location,
                  leaf.name.substr(leaf.name.rfind('.') + 1), std::move(path)});
  list.back().is_of_patch = is_of_patch_;
  list.back().has_min_precision = program_.types.HasMinPrecision(leaf.type);
  if (is_target) list.back().blend_index = blend_index.value_or(0);
  return id;
}

// The number of the render target that an output goes to.
std::uint32_t InterfaceVars::TargetNumber(const Carrier& leaf) {
  const std::uint32_t number = leaf.cursor.location.value_or(leaf.cursor.semantic.index);
  const auto known = std::ranges::find_if(program_.outputs, [&](const IoVar& output) {
    return output.builtin == Builtin::kNone && output.location == number &&
           output.blend_index == leaf.cursor.blend_index.value_or(0);
  });
  if (known != program_.outputs.end())
    diagnostics_.Report(leaf.span, diag::LocationTwice, number, leaf.name, known->path);
  return number;
}

VarId InterfaceVars::AddDistances(Builtin builtin, const Distances& pieces,
                                  std::span<const ExprId> packed) {
  const auto count = static_cast<std::uint32_t>(packed.size());
  const Span span = pieces.span();
  const bool is_clip = builtin == Builtin::kClipDistance || builtin == Builtin::kClipDistanceInput;
  const bool is_input = InfoOf(builtin).storage == Storage::kInput;
  DistanceCount& all = distances_[is_input];
  all.count += count;
  all.span = all.span ? all.span : span;
  Carrier leaf;
  leaf.type = program_.types.Array(program_.types.Make(Scalar::kFloat), count);
  leaf.name = is_clip ? "clip_distance" : "cull_distance";
  leaf.cursor.semantic.name = is_clip ? "SV_ClipDistance" : "SV_CullDistance";
  leaf.span = span;
  const VarId array = Add(is_input ? program_.inputs : program_.outputs, leaf, leaf.type, builtin);
  program_.vars[array].name = leaf.name;
  for (const Distances::Piece& piece : pieces.pieces()) {
    const auto first = std::ranges::find(packed, piece.components.front()) - packed.begin();
    program_.distances.push_back({.array = array,
                                  .index = piece.index,
                                  .first = static_cast<std::uint32_t>(first),
                                  .count = static_cast<std::uint32_t>(piece.components.size())});
  }
  return array;
}

void InterfaceVars::PlaceConstants() {
  for (auto* list : {&program_.inputs, &program_.outputs}) {
    std::uint32_t end = 0;
    for (const IoVar& io : *list) {
      if (io.builtin == Builtin::kNone && !io.is_of_patch)
        end =
            std::max(end, io.location + LocationCount(program_.types[program_.vars[io.var].type]));
    }
    for (IoVar& io : *list) {
      if (io.builtin == Builtin::kNone && io.is_of_patch && !io.is_placed) io.location += end;
    }
  }
}

void InterfaceVars::CheckDistances() {
  for (const auto& [count, span] : distances_) {
    if (count > kMaxDistances) diagnostics_.Report(span, diag::TooManyClipDistances, count);
  }
}

TypeId TypeOf(TypeTable& types, Builtin builtin) {
  const BuiltinInfo& info = InfoOf(builtin);
  return info.components == 1 ? types.Make(info.scalar)
                              : types.Vector(info.scalar, info.components);
}

TypeId StoredType(TypeTable& types, TypeId id) {
  const Scalar base = BaseOf(types[id].scalar);
  return types.WithScalar(id, base == Scalar::kBool ? Scalar::kUint : base);
}

ExprId Fit(Program& program, Builder& builder, ExprId value, TypeId type) {
  value = builder.ConvertTo(program.types[type].scalar, value);
  if (builder.TypeOf(value) == type) return value;
  const bool to_vector = program.types[type].kind == TypeKind::kVector;
  return to_vector ? builder.ConstructOf(type, {value}) : builder.Swizzled(value, {0});
}

}  // namespace clipc::signature
