// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/structs.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ir/packing.h"

namespace clipc {
namespace {

using ir::Program;
using ir::Scalar;
using ir::Type;
using ir::TypeId;
using ir::TypeKind;

constexpr std::uint32_t kRow = 16;

// The keywords of C++20 and C23 that are not keywords of HLSL.
constexpr std::string_view kKeywords[] = {
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "catch",
    "char",
    "char16_t",
    "char32_t",
    "char8_t",
    "class",
    "co_await",
    "co_return",
    "co_yield",
    "compl",
    "concept",
    "const_cast",
    "consteval",
    "constexpr",
    "constinit",
    "decltype",
    "delete",
    "dynamic_cast",
    "enum",
    "explicit",
    "export",
    "friend",
    "goto",
    "long",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "register",
    "requires",
    "reinterpret_cast",
    "restrict",
    "short",
    "signed",
    "sizeof",
    "static_assert",
    "static_cast",
    "template",
    "this",
    "thread_local",
    "throw",
    "try",
    "typeid",
    "typename",
    "typeof",
    "union",
    "unsigned",
    "using",
    "virtual",
    "wchar_t",
    "xor",
    "xor_eq",
};

std::string Identifier(std::string_view name) {
  std::string identifier;
  for (const char c : name) {
    if (c == '$') continue;  // of "$Globals"
    const bool is_word = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    identifier += is_word ? c : '_';
  }
  const bool is_keyword = std::ranges::find(kKeywords, identifier) != std::end(kKeywords);
  return is_keyword ? identifier + "_" : identifier;
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
  Header(const Program& program, std::string_view prefix, const Header* first)
      : program_(program), types_(program.types), prefix_(prefix), first_(first) {}

  std::string Write() {
    for (const ir::CbufferId id : program_.cbuffers.ids()) AddBuffer(program_.cbuffers[id]);
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

  void AddMember(Body& body, std::string_view written, TypeId type, bool row_major,
                 std::uint32_t offset) {
    const std::uint32_t size = ir::PackedExtent(types_, type, row_major).size;
    if (size == 0) return;  // an object in a struct is not a constant
    Pad(body, offset);
    const std::string name = Identifier(written);
    fmt::format_to(std::back_inserter(body.members), "  {};  // {}{}\n",
                   Declaration(name, type, row_major), row_major ? "row_major " : "",
                   types_.Name(type));
    body.offsets.emplace_back(name, offset);
    body.end = offset + size;
  }

  // The declaration of a member, such as "float view[16]".
  std::string Declaration(const std::string& name, TypeId id, bool row_major) {
    std::string lengths;
    TypeId element = id;
    std::uint32_t size = ir::PackedExtent(types_, id, row_major).size;
    const auto as_words = [&](const char* word, std::uint32_t bytes) {
      return fmt::format("{} {}{}[{}]", word, name, lengths, size / bytes);
    };
    while (types_[element].kind == TypeKind::kArray) {
      const Type& array = types_[element];
      const std::uint32_t stride = ir::ArrayStride(types_, element, row_major);
      if (ir::PackedExtent(types_, array.element, row_major).size != stride) break;
      fmt::format_to(std::back_inserter(lengths), "[{}]", array.count);
      element = array.element;
      size = stride;
    }
    const Type& type = types_[element];
    if (type.kind == TypeKind::kStruct)
      return fmt::format("struct {} {}{}", AddStruct(element), name, lengths);
    const TypeId innermost = types_.Innermost(element);
    if (!types_[innermost].IsNumeric()) return as_words("uint32_t", 4);
    const char* const scalar = NameOfScalar(types_[innermost].scalar);
    if (type.kind == TypeKind::kScalar) return fmt::format("{} {}{}", scalar, name, lengths);
    const bool is_wide = std::string_view(scalar) == "double" ||
                         std::string_view(scalar).find("64") != std::string_view::npos;
    return as_words(scalar, is_wide ? 8 : 4);
  }

  // Adds a struct and returns its name. A struct ends where its last member ends, so that the next
  // member after it may use the rest of that row, as in HLSL.
  std::string AddStruct(TypeId type) {
    const ir::StructId id = types_[type].structure;
    if (const auto known = structs_.find(id); known != structs_.end()) return known->second;
    const ir::Struct& structure = types_.StructOf(type);
    Body body{NewName(structure.name), {}, {}};
    for (std::uint32_t i = 0; i < structure.fields.size(); ++i) {
      const ir::Field& field = structure.fields[i];
      AddMember(body, field.name, field.type, field.row_major, ir::FieldOffset(types_, id, i));
    }
    Close(body, fmt::format("struct {}", structure.name));
    structs_.emplace(id, body.name);
    return body.name;
  }

  void AddBuffer(const ir::Cbuffer& buffer) {
    Body body{NewName(buffer.name), {}, {}};
    std::vector<ir::CbufferMember> members = buffer.members;
    std::ranges::stable_sort(members, {}, &ir::CbufferMember::offset);
    for (const ir::CbufferMember& member : members) {
      const ir::Var& var = program_.vars[member.var];
      TypeId type = var.type;
      if (buffer.count != 1 && types_[type].kind == TypeKind::kArray) type = types_[type].element;
      if (member.offset >= body.end) {
        AddMember(body, var.name, type, var.row_major, member.offset);
      } else {  // `register(c#)` puts the member over another
        fmt::format_to(std::back_inserter(body.members), "  // {} at byte {}\n",
                       Identifier(var.name), member.offset);
      }
    }
    Pad(body, static_cast<std::uint32_t>(ir::RoundUp(buffer.size, kRow)));
    Close(body, fmt::format("{}, b{}, space {}", buffer.name, buffer.reg.number, buffer.reg.space));
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

  const Program& program_;
  const ir::TypeTable& types_;
  const std::string prefix_;  // of the names of structs
  const Header* const first_;
  std::set<std::string> names_;
  std::map<std::string, std::string> members_;  // of each struct, by its name
  std::map<ir::StructId, std::string> structs_;
  std::string text_;
};

}  // namespace

std::string WriteStructs(const Program& program, std::string_view prefix, const Program* pixel) {
  Header header(program, prefix, nullptr);
  std::string text = header.Write();
  if (pixel) text += Header(*pixel, prefix, &header).Write();
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
