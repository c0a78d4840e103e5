// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/memory.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>

#include "backend-glsl/names.h"
#include "ir/packing.h"
#include "tools/draw/textures.h"

namespace clipc::draw {
namespace {

using namespace ir;

// A part of a constant buffer.
struct Part {
  TypeId type;
  std::uint32_t offset = 0;
  bool row_major = false;
  int row = -1;  // of a matrix: this row only
};

std::uint32_t RoundUp(std::uint32_t value, std::uint32_t multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

std::uint32_t StructuredOffset(const TypeTable& types, StructId structure, std::uint32_t field) {
  std::uint32_t offset = 0;
  for (std::uint32_t i = 0;; ++i) {
    const StructuredSize place = StructuredSizeOf(types, types[structure].fields[i].type);
    offset = RoundUp(offset, place.alignment);
    if (i == field) return offset;
    offset += place.size;
  }
}

Part FieldOf(const TypeTable& types, const Part& part, std::uint32_t field, Packing packing) {
  const StructId structure = types[part.type].structure;
  const Field& declared = types[structure].fields[field];
  const std::uint32_t offset = packing == Packing::kConstants
                                   ? FieldOffset(types, structure, field)
                                   : StructuredOffset(types, structure, field);
  return {declared.type, part.offset + offset, declared.row_major};
}

Part ElementOf(const TypeTable& types, const Part& part, std::uint32_t index, Packing packing) {
  const TypeId element = types[part.type].element;
  const std::uint32_t stride = packing == Packing::kConstants
                                   ? ArrayStride(types, part.type, part.row_major)
                                   : StructuredSizeOf(types, element).size;
  return {element, part.offset + index * stride, part.row_major};
}

// Follows ".field" and "[index]" of a name that OpenGL gives a uniform. Returns the part that the
// name means; none if `part` does not have it.
std::optional<Part> Follow(const TypeTable& types, Part part, std::string_view path) {
  while (!path.empty()) {
    const Type& type = types[part.type];
    const std::size_t end = std::min(path.find_first_of(".[", 1), path.size());
    const std::string step(path.substr(1, end - 1));
    if (path[0] == '[' && type.kind == TypeKind::kArray) {
      part = ElementOf(types, part, std::stoul(step), Packing::kConstants);
    } else if (path[0] == '.' && type.kind == TypeKind::kStruct) {
      const auto& fields = types[type.structure].fields;
      const auto found = std::ranges::find_if(
          fields, [&](const Field& field) { return glsl::LegalFieldName(field.name) == step; });
      if (found == fields.end()) return std::nullopt;
      part = FieldOf(types, part, found - fields.begin(), Packing::kConstants);
    } else if (path[0] == '.' && type.kind == TypeKind::kArray && step.size() > 1) {
      // `.e2` of a struct that stands for an array
      part = ElementOf(types, part, std::stoul(step.substr(1)), Packing::kConstants);
    } else if (path[0] == '.' && type.kind == TypeKind::kMatrix && step.size() > 1) {
      part.row = std::stoi(step.substr(1));  // row 2 in `.e2` of a struct that stands for a matrix
    } else if (step != "e") {                // a struct around an inner array
      return std::nullopt;
    }
    path.remove_prefix(end);
  }
  return part;
}

Words ReadWords(const TypeTable& types, const Part& part, const Bytes& bytes) {
  Words words;
  ForEachComponent(types, part.type, part.row_major, part.offset,
                   [&](Scalar kind, std::uint32_t byte) {
                     std::uint32_t word = 0;
                     std::memcpy(&word, &bytes.at(byte), 4);
                     words.push_back(kind == Scalar::kBool ? word != 0 : word);
                   });
  if (part.row < 0) return words;
  const std::ptrdiff_t columns = types[part.type].columns;
  const auto first = words.begin() + part.row * columns;
  return {first, first + columns};
}

// The words of an active uniform; empty when it is not a part of that member.
Words WordsOf(const Program& program, const CbufferMember& member, std::string_view path,
              const Bytes& bytes) {
  const Var& var = program.vars[member.var];
  const bool is_array = path.ends_with("[0]");
  if (is_array) path.remove_suffix(3);
  const std::optional<Part> part =
      Follow(program.types, {var.type, member.offset, var.row_major}, path);
  return part ? ReadWords(program.types, *part, bytes) : Words{};
}

// The words of the uniform that OpenGL calls `name`; empty when it is not a part of the block's
// members.
Words UniformOf(const Program& program, const GlslInfo::UniformBlock& block, const Bytes& bytes,
                const std::string& name) {
  for (const GlslInfo::UniformMember& member : block.members) {
    if (!name.starts_with(member.name)) continue;
    const std::string_view path = std::string_view(name).substr(member.name.size());
    if (!path.empty() && path[0] != '.' && path[0] != '[') continue;
    for (const CbufferMember& declared : program.cbuffers[block.cbuffer].members) {
      if (declared.var == member.var) return WordsOf(program, declared, path, bytes);
    }
  }
  return {};
}

}  // namespace

StructuredSize StructuredSizeOf(const TypeTable& types, TypeId id) {
  const Type& type = types[id];
  if (type.kind == TypeKind::kArray) {
    const StructuredSize element = StructuredSizeOf(types, type.element);
    return {element.size * type.count, element.alignment};
  }
  if (type.kind != TypeKind::kStruct) {
    const std::uint32_t size = ByteSize(type.scalar);
    return {size * type.Components(), size};
  }
  StructuredSize all;
  const auto& fields = types[type.structure].fields;
  for (std::uint32_t i = 0; i < fields.size(); ++i) {
    const StructuredSize place = StructuredSizeOf(types, fields[i].type);
    all.size = StructuredOffset(types, type.structure, i) + place.size;
    all.alignment = std::max(all.alignment, place.alignment);
  }
  all.size = RoundUp(all.size, all.alignment);
  return all;
}

void ForEachComponent(const TypeTable& types, TypeId type_id, bool row_major, std::uint32_t offset,
                      const std::function<void(Scalar kind, std::uint32_t byte)>& visit,
                      Packing packing) {
  const Type type = types[type_id];
  const auto go_on = [&](const Part& part) {
    ForEachComponent(types, part.type, part.row_major, part.offset, visit, packing);
  };
  const Part whole = {type_id, offset, row_major};
  if (type.kind == TypeKind::kArray) {
    for (std::uint32_t i = 0; i < type.count; ++i) go_on(ElementOf(types, whole, i, packing));
    return;
  }
  if (type.kind == TypeKind::kStruct) {
    for (std::uint32_t i = 0; i < types[type.structure].fields.size(); ++i)
      go_on(FieldOf(types, whole, i, packing));
    return;
  }
  const bool is_constant = packing == Packing::kConstants;
  const std::uint32_t size = ByteSize(type.scalar);
  if (is_constant && size == 8) throw DrawError("64-bit constants, which no test draws with");
  const bool by_row = type.kind != TypeKind::kMatrix || row_major;
  const std::uint32_t stride = is_constant ? 16 : size * (by_row ? type.columns : type.rows);
  for (std::uint32_t row = 0; row < type.rows; ++row) {
    for (std::uint32_t column = 0; column < type.columns; ++column) {
      visit(BaseOf(type.scalar),
            offset + (by_row ? row * stride + size * column : column * stride + size * row));
    }
  }
}

std::vector<std::string> BlockNames(const Program& program, const GlslInfo::UniformBlock& block) {
  const Cbuffer& declared = program.cbuffers[block.cbuffer];
  if (declared.kind != CbufferKind::kConstantBuffer) return {block.name};
  std::vector<std::string> names = ElementIndices(program, declared.members.front().var);
  names.resize(std::min<std::size_t>(names.size(), declared.count));  // none without a size
  for (std::string& name : names) name.insert(0, block.name);
  return names;
}

void GiveConstants(const Program& program, const GlslInfo& info, const std::vector<Bytes>& cbuffers,
                   Inputs& inputs) {
  for (const GlslInfo::UniformBlock& block : info.blocks) {
    const Cbuffer& declared = program.cbuffers[block.cbuffer];
    const Bytes& bytes = cbuffers[block.cbuffer.index];
    if (block.name.empty()) continue;
    auto begin = bytes.begin();
    for (const std::string& name : BlockNames(program, block)) {
      inputs.blocks.push_back({name, {begin, begin + declared.size}});
      begin += declared.size;
    }
  }
  inputs.find_uniform = [&](const std::string& name) {
    Words words;
    for (const GlslInfo::UniformBlock& block : info.blocks) {
      if (!block.name.empty() || !words.empty()) continue;
      const Bytes& bytes = cbuffers[block.cbuffer.index];
      const bool is_rows = !block.rows.empty() && name == block.rows + "[0]";
      words = is_rows ? WordsOf(bytes) : UniformOf(program, block, bytes, name);
    }
    return words;
  };
}

}  // namespace clipc::draw
