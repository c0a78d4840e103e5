// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Structs, constant buffers, and the clip planes that lie in them.
#include <algorithm>

#include "tools/random/interface.h"
#include "tools/random/layout.h"

namespace clipc::random {
namespace {

const char* MakeMajor(Context& context, const Type& type) {
  if (!type.shape.IsMatrix() || type.structure >= 0) return "";
  constexpr const char* kMajors[] = {"", "row_major ", "column_major "};
  return context.OneOf(kMajors);
}

bool IsRowMajor(const std::string& major, bool by_default) {
  return major.empty() ? by_default : major == "row_major ";
}

// The type of a member, made for planes about one time in three.
Type MakeMemberType(Context& context) {
  const std::uint32_t structs = context.structs.empty() ? 0 : 1;
  const std::size_t choice = context.Pick({2, 1, structs});
  if (choice == 0) return MakeType(context);
  Type type{Kind::kFloat, {0, 4}};
  if (choice == 2) {
    const auto count = static_cast<std::uint32_t>(context.structs.size());
    type.structure = static_cast<int>(context.Below(count));
    return type;
  }
  if (context.Chance(40)) type.sizes.push_back(context.Between(1, 3));
  if (context.Chance(20)) type.shape.rows = 4;
  return type;
}

// The type of a field, now and then a matrix: two in one struct may lie in different ways.
Type MakeFieldType(Context& context) {
  if (!context.Has(Feature::kMatrices) || !context.Chance(25)) return MakeType(context);
  return {Kind::kFloat, {context.Between(2, 4), context.Between(2, 4)}};
}

std::string PackOffset(int bytes) {
  std::string text = " : packoffset(c" + std::to_string(bytes / 16);
  if (bytes % 16 != 0) text += std::string(".") + "xyzw"[bytes % 16 / 4];
  return text + ")";
}

// Gives each member a packoffset, up to five components after the end of the one before, or at the
// next register.
void PlaceMembers(Context& context, const Structs& structs, ConstantBuffer& buffer) {
  int end = 0;
  for (Member& member : buffer.members) {
    const Extent extent = ExtentOf(structs, member.type, member.row_major);
    int at = end + 4 * context.Between(0, 5);
    if (extent.starts_row || at % 16 + extent.size > 16) at = (at + 15) / 16 * 16;
    member.packoffset = at;
    end = at + extent.size;
  }
}

struct Operand {
  std::string text;
  bool composed = false;
};

// Collects the parts of a constant that a plane can be.
void CollectPlanes(Context& context, const std::string& text, const Type& type,
                   std::vector<Operand>& found) {
  if (type.IsArray()) {
    const int element = context.Between(0, type.sizes[0] - 1);
    return CollectPlanes(context, text + "[" + std::to_string(element) + "]", type.Element(),
                         found);
  }
  if (type.IsStruct()) {
    for (const Field& field : context.structs[type.structure].fields)
      CollectPlanes(context, text + "." + field.name, field.type, found);
    return;
  }
  if (type.kind != Kind::kFloat) return;
  if (type.shape == Shape{0, 4}) {
    constexpr const char* kSame[] = {"", "", ".xyzw", ".rgba"};
    found.push_back({text + context.OneOf(kSame)});
    if (context.Chance(30)) found.push_back({"(" + text + ")"});
    found.push_back({text + ".wzyx", true});
    found.push_back({"float4(" + text + ".xy, " + text + ".zw)", true});
  } else if (type.shape.IsMatrix() && type.shape.columns == 4) {
    const int row = context.Between(0, type.shape.rows - 1);
    found.push_back({text + "[" + std::to_string(row) + "]", true});
    if (type.shape.rows == 4) found.push_back({text + "._m00_m10_m20_m30", true});
  } else if (type.shape.IsScalar()) {
    found.push_back({text + ".xxxx", true});
    found.push_back({"float4(" + text + ", " + text + ", " + text + ", " + text + ")", true});
  }
}

}  // namespace

std::string MakeStruct(Context& context) {
  const SpanOf span(context.choices);
  Struct structure{"S" + std::to_string(context.structs.size()), {}};
  std::string fields;
  const auto add = [&](int) {
    Field field{context.FreshName("m"), MakeFieldType(context)};
    const auto same = std::ranges::find(structure.fields, field.name, &Field::name);
    if (same != structure.fields.end()) return;
    field.major = MakeMajor(context, field.type);
    fields += "  " + field.major + Declaration(context.structs, field.type, field.name) + ";\n";
    structure.fields.push_back(field);
  };
  add(0);
  Repeat(context.choices, 3, 60, add);
  context.structs.push_back(structure);
  return "struct " + structure.name + " {\n" + fields + "};\n";
}

std::string MakeConstants(Context& context, bool row_major, std::vector<ConstantBuffer>& buffers) {
  std::string text;
  Repeat(context.choices, 3, 60, [&](int i) {
    const bool is_globals = i == 0 && context.Chance(40);
    ConstantBuffer buffer{is_globals ? "$Globals" : "B" + std::to_string(i), {}};
    std::vector<std::string> majors;
    Repeat(context.choices, 5, 75, [&](int) {
      Member member{context.FreshName("c"), MakeMemberType(context)};
      majors.emplace_back(MakeMajor(context, member.type));
      member.row_major = IsRowMajor(majors.back(), row_major);
      context.Add({member.name, member.type, false, Holds::kInput});
      buffer.members.push_back(member);
    });
    if (buffer.members.empty()) return;
    const bool places = !is_globals && context.Chance(25);
    Structs structs = context.structs;
    if (places) PlaceMembers(context, WithMajors(structs, row_major), buffer);
    if (!is_globals) text += "cbuffer " + buffer.name + " {\n";
    for (std::size_t k = 0; k < buffer.members.size(); ++k) {
      const Member& member = buffer.members[k];
      text += (is_globals ? "" : "  ") + majors[k] +
              Declaration(context.structs, member.type, member.name) +
              (member.packoffset >= 0 ? PackOffset(member.packoffset) : "") + ";\n";
    }
    if (!is_globals) text += "};\n";
    buffers.push_back(buffer);
  });
  return text;
}

std::string MakePlanes(Context& context, const std::vector<ConstantBuffer>& buffers, bool composes,
                       int most) {
  std::vector<Operand> found;
  for (const ConstantBuffer& buffer : buffers) {
    for (const Member& member : buffer.members)
      CollectPlanes(context, member.name, member.type, found);
  }
  if (!composes) std::erase_if(found, [](const Operand& operand) { return operand.composed; });
  if (found.empty()) return {};
  std::string text;
  Repeat(context.choices, most, 75,
         [&](int) { text += (text.empty() ? "" : ", ") + context.OneOf(found).text; });
  return text.empty() ? text : "[clipplanes(" + text + ")]\n";
}

}  // namespace clipc::random
