// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "link/members.h"

#include "ir/packing.h"

namespace clipc::link {
namespace {

UniformMember MemberOf(const ir::TypeTable& types, std::string name, ir::TypeId type,
                       bool row_major, std::uint32_t offset);

std::vector<UniformMember> FieldsOf(const ir::TypeTable& types, ir::StructId id) {
  std::vector<UniformMember> fields;
  for (std::uint32_t i = 0; i < types[id].fields.size(); ++i) {
    const ir::Field& field = types[id].fields[i];
    fields.push_back(
        MemberOf(types, field.name, field.type, field.row_major, ir::FieldOffset(types, id, i)));
  }
  return fields;
}

UniformMember MemberOf(const ir::TypeTable& types, std::string name, ir::TypeId type,
                       bool row_major, std::uint32_t offset) {
  UniformMember member;
  member.name = std::move(name);
  member.offset = offset;
  member.type = GlslTypeOf(types, type);
  if (member.type) {
    if (member.type->columns > 1)
      member.matrices = row_major ? ir::MatrixLayout::kColumnMajor : ir::MatrixLayout::kRowMajor;
    return member;
  }
  for (; types[type].kind == ir::TypeKind::kArray; type = types[type].element)
    member.struct_dimensions.push_back(types[type].count);
  if (types[type].kind == ir::TypeKind::kStruct)
    member.fields = FieldsOf(types, types[type].structure);
  return member;
}

}  // namespace

std::vector<UniformMember> MembersOf(const ir::Program& program, const ir::Cbuffer& cbuffer) {
  std::vector<UniformMember> members;
  if (cbuffer.kind == ir::CbufferKind::kConstantBuffer) {
    ir::TypeId type = program.vars[cbuffer.members.front().var].type;
    while (program.types[type].kind == ir::TypeKind::kArray) type = program.types[type].element;
    return FieldsOf(program.types, program.types[type].structure);
  }
  for (const ir::CbufferMember& member : cbuffer.members) {
    const ir::Var& var = program.vars[member.var];
    members.push_back(MemberOf(program.types, var.name, var.type, var.row_major, member.offset));
  }
  return members;
}

}  // namespace clipc::link
