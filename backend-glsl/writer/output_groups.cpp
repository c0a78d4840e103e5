// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/output_groups.h"

#include <algorithm>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/types.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// Whether GLSL cannot interpolate numbers of this kind.
bool IsFlat(Scalar scalar) { return scalar != Scalar::kFloat; }

// The output that is the member, or its first element; null if the shader writes none.
const IoVar* OutputOf(const WriterContext& context, std::size_t group, std::size_t member) {
  const auto found = std::ranges::find_if(context.program.outputs, [&](const IoVar& output) {
    return output.reader && output.reader->group == group && output.reader->member == member;
  });
  return found == context.program.outputs.end() ? nullptr : &*found;
}

bool IsPrecise(const WriterContext& context, std::size_t group, std::size_t member) {
  return std::ranges::any_of(context.program.outputs, [&](const IoVar& output) {
    return output.reader && output.reader->group == group && output.reader->member == member &&
           context[output.var].precise;
  });
}

// The line "    flat uvec2 cell[2];  // CELL0" of a member; without the qualifiers in a struct.
std::string MemberText(WriterContext& context, std::size_t group, std::size_t number,
                       bool has_locations) {
  const OutputGroup& whole = context.program.output_groups[group];
  const OutputGroup::GroupMember& member = whole.members[number];
  std::string text = "    ";
  if (whole.is_block) {
    Append(text, LocationText{has_locations ? member.location : std::nullopt},
           PreciseText(context, IsPrecise(context, group, number)),
           InterpolationText(
               context, {member.scalar, member.interpolation, member.centroid, member.sample}));
  }
  const Shape shape = ShapeOf(member.scalar, member.columns, member.components);
  AppendDeclaration(context, text, shape, member.name);
  for (const std::uint32_t dimension : member.dimensions) Append(text, "[", dimension, "]");
  if (const IoVar* output = OutputOf(context, group, number))
    Append(text, ";", SemanticComment{*output, member.name});
  else
    text += ";\n";
  return text;
}

// The qualifiers of a struct, whose members have none: those of its first member, and `flat` where
// one of them must be.
std::string StructInterpolation(WriterContext& context, const OutputGroup& group) {
  const OutputGroup::GroupMember& first = group.members.front();
  Interpolated whole{first.scalar, first.interpolation, first.centroid, first.sample};
  for (const OutputGroup::GroupMember& member : group.members) {
    if (IsFlat(member.scalar)) whole.scalar = member.scalar;
  }
  return InterpolationText(context, whole);
}

void WriteGroup(WriterContext& context, std::size_t number, std::string& text) {
  const OutputGroup& group = context.program.output_groups[number];
  const auto is_placed = [](const OutputGroup::GroupMember& member) {
    return member.location.has_value();
  };
  const bool has_locations = context.Has(Feature::kOutputLocations) &&
                             (!group.is_block || context.Has(Feature::kBlockLocations)) &&
                             (group.location || std::ranges::any_of(group.members, is_placed));
  if (group.is_block) context.Require(Feature::kOutputBlocks);
  if (group.is_block && has_locations) context.Require(Feature::kBlockLocations);
  std::string members;
  for (std::size_t i = 0; i < group.members.size(); ++i)
    members += MemberText(context, number, i, has_locations);
  LocationText location;
  if (has_locations) location.location = group.location;
  const std::string& instance = context.names.groups[number];
  if (group.is_block) {
    Append(text, location, "out ", group.type, " {\n", members, "}", instance.empty() ? "" : " ",
           instance, ";\n");
  } else {
    Append(text, "struct ", group.type, " {\n", members, "};\n", location,
           StructInterpolation(context, group), "out ", group.type, " ", instance, ";\n");
  }
}

}  // namespace

void AppendPart(std::string& text, const LocationText& part) {
  if (part.location) Append(text, "layout(location = ", *part.location, ") ");
}

void AppendPart(std::string& text, const SemanticComment& part) {
  const IoVar& io = part.io;
  text += "  // ";
  if (!io.name.empty() && io.name != part.name) Append(text, io.name, " : ");
  Append(text, io.semantic, io.index, "\n");
}

std::string InterpolationText(WriterContext& context, const Interpolated& output) {
  const bool is_flat =
      IsFlat(output.scalar) || output.interpolation == Interpolation::kNoInterpolation;
  const bool is_linear = !is_flat && output.interpolation == Interpolation::kNoPerspective;
  if (output.sample) context.Require(Feature::kPerSample);
  return Concat(is_flat && context.Has(Feature::kInAndOut) ? "flat " : "",
                is_linear ? "noperspective " : "", output.centroid ? "centroid " : "",
                output.sample ? "sample " : "");
}

std::string GroupsText(WriterContext& context) {
  std::string text;
  for (std::size_t i = 0; i < context.program.output_groups.size(); ++i)
    WriteGroup(context, i, text);
  return text;
}

}  // namespace clipc::glsl
