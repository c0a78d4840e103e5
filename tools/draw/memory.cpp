// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/memory.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "backend-glsl/names.h"
#include "ir/packing.h"

namespace clipc::draw {
namespace {

// A part of a constant buffer.
struct Part {
  ir::TypeId type;
  std::uint32_t offset = 0;
  bool row_major = false;
};

Part FieldOf(const ir::TypeTable& types, const Part& part, std::uint32_t field) {
  const ir::StructId structure = types[part.type].structure;
  const ir::Field& declared = types[structure].fields[field];
  return {declared.type, part.offset + ir::FieldOffset(types, structure, field),
          declared.row_major};
}

Part ElementOf(const ir::TypeTable& types, const Part& part, std::uint32_t index) {
  const std::uint32_t stride = ir::ArrayStride(types, part.type, part.row_major);
  return {types[part.type].element, part.offset + index * stride, part.row_major};
}

// Follows ".field" and "[index]" of a name that OpenGL gives a uniform.
std::optional<Part> Follow(const ir::TypeTable& types, Part part, std::string_view path) {
  while (!path.empty()) {
    const ir::Type& type = types[part.type];
    const std::size_t end = std::min(path.find_first_of(".[", 1), path.size());
    const std::string step(path.substr(1, end - 1));
    if (path[0] == '[' && type.kind == ir::TypeKind::kArray) {
      part = ElementOf(types, part, static_cast<std::uint32_t>(std::stoul(step)));
    } else if (path[0] == '.' && type.kind == ir::TypeKind::kStruct) {
      const auto& fields = types[type.structure].fields;
      const auto found = std::find_if(fields.begin(), fields.end(), [&](const ir::Field& field) {
        return glsl::LegalFieldName(field.name) == step;
      });
      if (found == fields.end()) return std::nullopt;
      part = FieldOf(types, part, static_cast<std::uint32_t>(found - fields.begin()));
    } else {
      return std::nullopt;
    }
    path.remove_prefix(end);
  }
  return part;
}

void AppendWords(const ir::TypeTable& types, const Part& part,
                 const std::vector<std::uint8_t>& bytes, std::vector<std::uint32_t>& words) {
  ForEachComponent(types, part.type, part.row_major, part.offset,
                   [&](ir::Scalar kind, std::uint32_t byte) {
                     std::uint32_t word = 0;
                     std::memcpy(&word, &bytes.at(byte), 4);
                     words.push_back(kind == ir::Scalar::kBool ? word != 0 : word);
                   });
}

// The words of an active uniform; empty when it is not a part of that member.
std::vector<std::uint32_t> WordsOf(const ir::Program& program, const ir::CbufferMember& member,
                                   std::string_view path, const std::vector<std::uint8_t>& bytes) {
  const ir::Var& var = program.vars[member.var];
  const bool is_array = path.ends_with("[0]");
  if (is_array) path.remove_suffix(3);
  const std::optional<Part> part =
      Follow(program.types, {var.type, member.offset, var.row_major}, path);
  std::vector<std::uint32_t> words;
  if (part) AppendWords(program.types, *part, bytes, words);
  return words;
}

// The words of the uniform that OpenGL calls `name`; empty when it is not a part of the block's
// members.
std::vector<std::uint32_t> UniformOf(const ir::Program& program, const glsl::GlslInfo::Block& block,
                                     const std::vector<std::uint8_t>& bytes,
                                     const std::string& name) {
  for (const glsl::GlslInfo::Member& member : block.members) {
    if (!name.starts_with(member.name)) continue;
    const std::string_view path = std::string_view(name).substr(member.name.size());
    if (!path.empty() && path[0] != '.' && path[0] != '[') continue;
    for (const ir::CbufferMember& declared : program.cbuffers[block.cbuffer].members) {
      if (declared.var == member.var) return WordsOf(program, declared, path, bytes);
    }
  }
  return {};
}

}  // namespace

void ForEachComponent(const ir::TypeTable& types, ir::TypeId type_id, bool row_major,
                      std::uint32_t offset,
                      const std::function<void(ir::Scalar kind, std::uint32_t byte)>& visit) {
  const ir::Type type = types[type_id];
  if (type.kind == ir::TypeKind::kArray) {
    for (std::uint32_t i = 0; i < type.count; ++i) {
      const Part element = ElementOf(types, {type_id, offset, row_major}, i);
      ForEachComponent(types, element.type, row_major, element.offset, visit);
    }
    return;
  }
  if (type.kind == ir::TypeKind::kStruct) {
    for (std::uint32_t i = 0; i < types[type.structure].fields.size(); ++i) {
      const Part field = FieldOf(types, {type_id, offset, row_major}, i);
      ForEachComponent(types, field.type, field.row_major, field.offset, visit);
    }
    return;
  }
  const ir::Scalar kind = ir::BaseOf(type.scalar);
  if (kind == ir::Scalar::kDouble || kind == ir::Scalar::kInt64 || kind == ir::Scalar::kUint64) {
    throw DrawError("64-bit constants, which no test draws with");
  }
  for (std::uint32_t row = 0; row < type.rows; ++row) {
    for (std::uint32_t column = 0; column < type.columns; ++column) {
      const bool by_row = type.kind != ir::TypeKind::kMatrix || row_major;
      visit(kind, offset + (by_row ? 16 * row + 4 * column : 16 * column + 4 * row));
    }
  }
}

void GiveConstants(const ir::Program& program, const glsl::GlslInfo& info,
                   const std::vector<std::vector<std::uint8_t>>& cbuffers, Inputs& inputs) {
  for (const glsl::GlslInfo::Block& block : info.blocks) {
    const ir::Cbuffer& declared = program.cbuffers[block.cbuffer];
    const std::vector<std::uint8_t>& bytes = cbuffers[block.cbuffer.index];
    if (block.form == glsl::BlockForm::kUniforms) continue;
    if (declared.count == 1) inputs.blocks.push_back({block.name, bytes});
    for (std::uint32_t i = 0; declared.count > 1 && i < declared.count; ++i) {
      const auto begin = bytes.begin() + i * declared.size;
      inputs.blocks.push_back(
          {block.name + "[" + std::to_string(i) + "]", {begin, begin + declared.size}});
    }
  }
  inputs.find_uniform = [&](const std::string& name) {
    std::vector<std::uint32_t> words;
    for (const glsl::GlslInfo::Block& block : info.blocks) {
      if (block.form != glsl::BlockForm::kUniforms || !words.empty()) continue;
      words = UniformOf(program, block, cbuffers[block.cbuffer.index], name);
    }
    return words;
  };
}

}  // namespace clipc::draw
