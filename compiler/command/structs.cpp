// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/command/structs.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "compiler/command/c_names.h"
#include "ir/packing.h"

namespace clipc {
namespace {

using ir::Scalar;
using ir::TypeKind;

constexpr std::uint32_t kRow = 16;

// Whether it is a name that Header::Pad gives: padding0_.
bool IsPadding(std::string_view name) {
  constexpr std::string_view kStart = "padding";
  if (!name.starts_with(kStart) || !name.ends_with('_')) return false;
  const std::string_view number = name.substr(kStart.size(), name.size() - kStart.size() - 1);
  return number.find_first_not_of("0123456789") == std::string_view::npos;
}

std::string Identifier(std::string_view name) {
  std::string identifier;
  for (const char c : name) {
    if (c == '$') continue;  // of "$Globals"
    const bool is_word = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    identifier += is_word ? c : '_';
  }
  const bool is_taken = IsKeywordInC(identifier) || IsMacroInC(identifier) || IsPadding(identifier);
  return is_taken ? identifier + "_" : identifier;
}

const char* NameOfScalar(Scalar scalar) {
  switch (ir::BaseOf(scalar)) {
    case Scalar::kInt: return "int32_t";
    case Scalar::kBool:
    case Scalar::kUint: return "uint32_t";
    case Scalar::kDouble: return "double";
    case Scalar::kInt64: return "int64_t";
    case Scalar::kUint64: return "uint64_t";
    default: return "float";
  }
}

class Header {
 public:
  // `first` is the header of the other shader of a pair, or null: a struct of one name that is
  // another there gets a new name.
  Header(const StageFacts& facts, std::string_view prefix, const Header* first)
      : facts_(facts), prefix_(prefix), first_(first) {}

  std::string Write() {
    for (const BufferFact& buffer : facts_.buffers) AddBuffer(buffer);
    if (facts_.group) AddGroup(*facts_.group);
    if (facts_.emission) AddEmission(*facts_.emission);
    if (facts_.tessellation) AddTessellation(*facts_.tessellation);
    return text_;
  }

 private:
  // The text of one struct: its members, with padding between them, and its assertions.
  struct Body {
    std::string name, members;
    std::vector<std::pair<std::string, std::uint32_t>> offsets;  // by the member's name
    std::uint32_t end = 0;
    int gaps = 0;
  };

  // A struct and a buffer, or structs of two namespaces, may have one name in HLSL.
  std::string NewName(std::string_view written) {
    const std::string name = Identifier(written);
    std::string unique = prefix_ + (name.empty() ? "Unnamed" : name);
    for (int i = 2; !names_.insert(unique).second; ++i)
      unique = fmt::format("{}{}_{}", prefix_, name, i);
    return unique;
  }

  // Gives the struct a name that the first header has not, if it is another there.
  void Distinguish(Body& body) {
    if (!first_) return;
    const auto other = first_->members_.find(body.name);
    if (other == first_->members_.end() || other->second == body.members) return;
    const std::string name = body.name;
    for (int i = 2; first_->names_.contains(body.name) || !names_.insert(body.name).second; ++i)
      body.name = fmt::format("{}_{}", name, i);
  }

  void Pad(Body& body, std::uint32_t to) {
    if (to <= body.end) return;
    fmt::format_to(std::back_inserter(body.members), "  uint32_t padding{}_[{}];\n", body.gaps++,
                   (to - body.end) / 4);
    body.end = to;
  }

  // Adds a member, or an element of one, which has so many subscripts; `type` is its type in HLSL.
  void AddMember(Body& body, const FieldFact& member, std::size_t subscripts,
                 std::string_view type) {
    const std::uint32_t size = member.shape.SizeAfter(subscripts);
    if (size == 0) return;  // an object in a struct is not a constant
    Pad(body, member.offset);
    const std::string name = Identifier(member.name);
    fmt::format_to(std::back_inserter(body.members), "  {};  // {}{}\n",
                   Declaration(name, member.shape, subscripts),
                   member.row_major ? "row_major " : "", type);
    body.offsets.emplace_back(name, member.offset);
    body.end = member.offset + size;
  }

  // The declaration of a member, such as "float view[16]".
  std::string Declaration(const std::string& name, const ShapeFact& shape, std::size_t subscripts) {
    std::string lengths;
    const auto as_words = [&](const char* word, std::uint32_t bytes) {
      return fmt::format("{} {}{}[{}]", word, name, lengths, shape.SizeAfter(subscripts) / bytes);
    };
    const std::size_t dimensions = shape.dimensions.size();
    for (; subscripts < dimensions; ++subscripts) {
      const ShapeFact::Dimension& dimension = shape.dimensions[subscripts];
      if (shape.SizeAfter(subscripts + 1) != dimension.stride) break;
      fmt::format_to(std::back_inserter(lengths), "[{}]", dimension.count);
    }
    const bool is_element = subscripts == dimensions;
    if (is_element && shape.structure)
      return fmt::format("struct {} {}{}", AddStruct(*shape.structure), name, lengths);
    const bool is_numeric = shape.kind == TypeKind::kScalar || shape.kind == TypeKind::kVector ||
                            shape.kind == TypeKind::kMatrix;
    if (!is_numeric) return as_words("uint32_t", 4);
    const char* const scalar = NameOfScalar(shape.scalar);
    if (is_element && shape.kind == TypeKind::kScalar)
      return fmt::format("{} {}{}", scalar, name, lengths);
    return as_words(scalar, ir::ByteSize(shape.scalar));
  }

  // Adds a struct and returns its name. A struct ends where its last member ends, so that the next
  // member after it may use the rest of that row, as in HLSL.
  std::string AddStruct(std::size_t number) {
    if (const auto known = structs_.find(number); known != structs_.end()) return known->second;
    const StructFact& structure = facts_.structs[number];
    Body body{NewName(structure.name), {}, {}};
    for (const FieldFact& field : structure.fields) AddMember(body, field, 0, field.type);
    Close(body, fmt::format("struct {}", structure.name));
    structs_.emplace(number, body.name);
    return body.name;
  }

  void AddBuffer(const BufferFact& buffer) {
    Body body{NewName(buffer.name), {}, {}};
    std::vector<const MemberFact*> members;
    for (const MemberFact& member : buffer.members) members.push_back(&member);
    std::ranges::stable_sort(members, {}, &MemberFact::offset);
    for (const MemberFact* member : members) {
      // An array of buffers is one struct, of an element.
      const bool is_array = buffer.count != 1 && !member->shape.dimensions.empty();
      if (member->offset < body.end) {  // `register(c#)` puts the member over another
        fmt::format_to(std::back_inserter(body.members), "  // {} at byte {}\n",
                       Identifier(member->name), member->offset);
      } else if (is_array) {
        AddMember(body, *member, 1, ElementType(member->shape));
      } else {
        AddMember(body, *member, 0, member->type);
      }
    }
    Pad(body, static_cast<std::uint32_t>(ir::RoundUp(buffer.size, kRow)));
    Close(body, fmt::format("{}, {}, space {}", buffer.name, buffer.reg.name, buffer.reg.space));
  }

  // The threads of a group, by which the host divides to dispatch.
  void AddGroup(const GroupFact& group) {
    const std::string name = NewName(facts_.entry);
    const auto [x, y, z] = group.size;
    fmt::format_to(std::back_inserter(text_),
                   "\n// {0}, which shares {4} bytes in a group\n"
                   "enum {{ {1}_group_x = {2}, {1}_group_y = {3}, {1}_group_z = {5} }};\n",
                   facts_.entry, name, x, y, group.shared_bytes, z);
  }

  // What a draw call must give, and how many vertices come of it.
  void AddEmission(const EmissionFact& emission) {
    const std::string name = NewName(facts_.entry);
    fmt::format_to(std::back_inserter(text_),
                   "\n// {0}, which takes a {2} and gives a {4}\n"
                   "enum {{ {1}_input_vertices = {3}, {1}_max_vertices = {5}, "
                   "{1}_instances = {6} }};\n",
                   facts_.entry, name, emission.input, emission.input_vertices, emission.output,
                   emission.max_vertices, emission.instances);
  }

  // The patches that a draw call must give to a hull shader, or a hull shader to a domain shader.
  void AddTessellation(const TessellationFact& patch) {
    const std::string name = NewName(facts_.entry);
    fmt::format_to(std::back_inserter(text_),
                   "\n// {0}, of the domain {2}, {3} and {4}\n"
                   "enum {{ {1}_input_points = {5}, {1}_output_points = {6} }};\n",
                   facts_.entry, name, patch.domain, patch.partitioning, patch.topology,
                   patch.input_points, patch.output_points);
  }

  // The type of an array's elements, which are structs.
  std::string ElementType(const ShapeFact& shape) const {
    std::string type = shape.structure ? facts_.structs[*shape.structure].name : "";
    for (const ShapeFact::Dimension& inner : std::span(shape.dimensions).subspan(1))
      fmt::format_to(std::back_inserter(type), "[{}]", inner.count);
    return type;
  }

  void Close(Body& body, std::string_view what) {
    if (body.members.empty()) return;
    Distinguish(body);
    members_.emplace(body.name, body.members);
    std::string assertions;
    for (const auto& [member, offset] : body.offsets) {
      fmt::format_to(std::back_inserter(assertions),
                     "CLIPC_ASSERT(offsetof(struct {0}, {1}) == {2}, \"{0}.{1}\");\n", body.name,
                     member, offset);
    }
    fmt::format_to(
        std::back_inserter(text_),
        "\n// {0}\n#ifndef CLIPC_STRUCT_{1}\n#define CLIPC_STRUCT_{1}\nstruct {1} {{\n{2}}};\n"
        "#endif\n{3}CLIPC_ASSERT(sizeof(struct {1}) == {4}, \"{1}\");\n",
        what, body.name, body.members, assertions, body.end);
  }

  const StageFacts& facts_;
  const std::string prefix_;  // of the names of structs
  const Header* const first_;
  std::set<std::string> names_;
  std::map<std::string, std::string> members_;  // of each struct, by its name
  std::map<std::size_t, std::string> structs_;  // by the number of the fact
  std::string text_;
};

}  // namespace

std::string WriteStructs(const Facts& facts, std::string_view prefix) {
  Header header(facts.stages.front(), prefix, nullptr);
  std::string text = header.Write();
  if (facts.stages.size() > 1) text += Header(facts.stages[1], prefix, &header).Write();
  return "// Written by clipc: constant buffers, byte by byte as Direct3D lays them out. A struct "
         "that\n"
         "// two shaders share is taken from the first; the assertions of the second hold for it "
         "too.\n"
         "#pragma once\n#include <stddef.h>\n#include <stdint.h>\n"
         "#ifndef CLIPC_ASSERT\n#ifdef __cplusplus\n"
         "#define CLIPC_ASSERT(condition, what) static_assert(condition, what)\n"
         "#else  // C99 has no assertion: an array of a negative size is an error\n"
         "#define CLIPC_ASSERT(condition, what) extern char clipc_assert[(condition) ? 1 : -1]\n"
         "#endif\n#endif\n"
         "#pragma pack(push, 4)\n" +
         text + "#pragma pack(pop)\n";
}

}  // namespace clipc
