// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/make_clip_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "backend-glsl/names.h"
#include "ir/packing.h"

namespace clipc {
namespace {

using UniformBlock = glsl::GlslInfo::UniformBlock;
using ir::Program;
using ir::Type;
using ir::TypeId;
using ir::TypeKind;
using ir::TypeTable;

constexpr std::uint32_t kRegister = 16;

// The path, such as ".state.planes[2]", of what lies `offset` bytes into a value of `type`.
std::string PathTo(const TypeTable& types, TypeId id, bool row_major, std::uint32_t offset) {
  const Type& type = types[id];
  if (type.kind == TypeKind::kArray) {
    const std::uint32_t stride = ir::ArrayStride(types, id, row_major);
    return fmt::format("[{}]", offset / stride) +
           PathTo(types, type.element, row_major, offset % stride);
  }
  if (type.kind == TypeKind::kStruct) {
    const ir::Struct& structure = types.StructOf(id);
    for (auto field = static_cast<std::uint32_t>(structure.fields.size()); field-- > 0;) {
      const std::uint32_t start = ir::FieldOffset(types, type.structure, field);
      if (start > offset) continue;
      const ir::Field& found = structure.fields[field];
      return "." + glsl::LegalFieldName(found.name) +
             PathTo(types, found.type, found.row_major, offset - start);
    }
  }
  // A matrix's row is what HLSL's m[i] names, and GLSL's.
  if (type.kind == TypeKind::kMatrix) return fmt::format("[{}]", offset / kRegister);
  return {};
}

// "[1][2]" for a buffer of an array of ConstantBuffers, and the type of the buffer itself.
std::string BufferIndex(const TypeTable& types, TypeId& type, std::uint32_t element,
                        std::uint32_t count) {
  std::string path;
  while (types[type].kind == TypeKind::kArray && count != 1) {
    count = types[type].count == 0 ? 1 : count / types[type].count;
    path += fmt::format("[{}]", element / count);
    element %= count;
    type = types[type].element;
  }
  return path;
}

// The GLSL name of what lies `offset` bytes into one buffer: a member of it, or a field of a
// ConstantBuffer's struct.
std::string MemberName(const Program& program, const UniformBlock& block,
                       const ir::Cbuffer& cbuffer, std::uint32_t element, std::uint32_t offset) {
  const TypeTable& types = program.types;
  for (const ir::CbufferMember& member : cbuffer.members) {
    if (offset < member.offset || offset - member.offset >= std::max(member.size, 1u)) continue;
    const ir::Var& var = program.vars[member.var];
    TypeId type = var.type;
    const std::string index = BufferIndex(types, type, element, cbuffer.count);
    const std::uint32_t rest = offset - member.offset;
    const glsl::GlslInfo::UniformMember* found = nullptr;
    for (const glsl::GlslInfo::UniformMember& named : block.members) {
      if (named.var != member.var) continue;
      if (!named.function.empty()) return named.NameAt(offset);
      if (named.field < 0) return named.name + index + PathTo(types, type, var.row_major, rest);
      const auto field = static_cast<std::uint32_t>(named.field);
      if (ir::FieldOffset(types, types[type].structure, field) <= rest) found = &named;
    }
    if (!found) return {};
    const auto field = static_cast<std::uint32_t>(found->field);
    const ir::Field& written = types.StructOf(type).fields[field];
    return found->name + PathTo(types, written.type, written.row_major,
                                rest - ir::FieldOffset(types, types[type].structure, field));
  }
  return {};
}

void NameInGlsl(const Program& program, const ir::ClipPlane& plane, const glsl::GlslInfo& info,
                clip_table::Constant& constant) {
  const UniformBlock* block = info.BlockOf(plane.cbuffer);
  if (!block) return;
  const ir::Cbuffer& cbuffer = program.cbuffers[plane.cbuffer];
  constant.glsl_block = block->name;
  if (cbuffer.count != 1 && !block->name.empty()) {
    TypeId type = program.vars[cbuffer.members.front().var].type;
    constant.glsl_block += BufferIndex(program.types, type, plane.element, cbuffer.count);
  }
  constant.glsl_member = block->form == glsl::BlockForm::kRows
                             ? fmt::format("{}[{}]", block->rows, plane.offset / kRegister)
                             : MemberName(program, *block, cbuffer, plane.element, plane.offset);
}

}  // namespace

clip_table::ClipTable MakeClipTable(const Lowered& lowered, const glsl::GlslInfo& info) {
  const Program& program = lowered.program;
  clip_table::ClipTable table;
  table.entry = program.functions[program.entry].name;
  table.profile = program.profile.name;
  table.lowering = lowered.lowering;
  table.plane_space = lowered.plane_space;
  table.enable_mask = clip_table::EnableMask(table.lowering, program.clip_planes.size());
  for (const ir::ClipPlane& plane : program.clip_planes) {
    clip_table::Plane& entry = table.planes.emplace_back();
    entry.index = static_cast<std::uint32_t>(table.planes.size() - 1);
    entry.text = plane.text;
    if (!plane.whole_register) continue;
    const ir::Cbuffer& cbuffer = program.cbuffers[plane.cbuffer];
    clip_table::Constant& constant = entry.constant.emplace();
    constant.cbuffer = cbuffer.name;
    constant.cbuffer_element = plane.element;
    constant.register_number = cbuffer.reg.number + plane.element;
    constant.register_space = cbuffer.reg.space;
    constant.float4_register = plane.offset / kRegister;
    constant.byte_offset = plane.offset;
    NameInGlsl(program, plane, info, constant);
  }
  return table;
}

}  // namespace clipc
