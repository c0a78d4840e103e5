// SPDX-License-Identifier: Apache-2.0
#include "compiler/make_clip_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "ir/packing.h"

namespace clipc {
namespace {

constexpr std::uint32_t kRegister = 16;

// ".state.planes[2]": what stands `offset` bytes into a value of `type`.
std::string PathTo(const ir::TypeTable& types, ir::TypeId id, bool row_major, std::uint32_t offset) {
  const ir::Type& type = types[id];
  if (type.kind == ir::TypeKind::kArray) {
    const std::uint32_t stride = ir::ArrayStride(types, id, row_major);
    return fmt::format("[{}]", offset / stride) + PathTo(types, type.element, row_major, offset % stride);
  }
  if (type.kind == ir::TypeKind::kStruct) {
    const ir::Struct& structure = types.StructOf(id);
    for (auto field = static_cast<std::uint32_t>(structure.fields.size()); field-- > 0;) {
      const std::uint32_t start = ir::FieldOffset(types, type.structure, field);
      if (start > offset) continue;
      const ir::Field& found = structure.fields[field];
      return "." + found.name + PathTo(types, found.type, found.row_major, offset - start);
    }
  }
  // A matrix's row is what HLSL's m[i] names, and GLSL's.
  if (type.kind == ir::TypeKind::kMatrix) return fmt::format("[{}]", offset / kRegister);
  return {};
}

void NameInGlsl(const ir::Program& program, const ir::ClipPlane& plane, const glsl::GlslInfo& info,
                clip_table::Constant& constant) {
  const auto block = std::find_if(info.blocks.begin(), info.blocks.end(),
                                  [&](const glsl::GlslInfo::Block& b) { return b.cbuffer == plane.cbuffer; });
  if (block == info.blocks.end()) return;
  constant.glsl_block = block->name;
  if (block->form == glsl::BlockForm::kRows) {
    constant.glsl_member = fmt::format("{}[{}]", block->rows, plane.offset / kRegister);
    return;
  }
  for (const ir::CbufferMember& member : program.cbuffers[plane.cbuffer].members) {
    if (plane.offset < member.offset || plane.offset - member.offset >= std::max(member.size, 1u)) continue;
    const ir::Var& var = program.vars[member.var];
    for (const glsl::GlslInfo::Member& named : block->members) {
      if (named.var != member.var) continue;
      constant.glsl_member = named.name + PathTo(program.types, var.type, var.row_major, plane.offset - member.offset);
    }
  }
}

}  // namespace

clip_table::ClipTable MakeClipTable(const ir::Program& program, clip_table::Lowering lowering,
                                    const glsl::GlslInfo& info) {
  clip_table::ClipTable table;
  table.entry = program.functions[program.entry].name;
  table.profile = program.profile.name;
  table.lowering = lowering;
  table.enable_mask = clip_table::EnableMask(lowering, program.clip_planes.size());
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
