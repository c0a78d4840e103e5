// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/context.h"

#include <algorithm>
#include <utility>

#include "backend-glsl/requirements.h"

namespace clipc::glsl {

WriterContext::WriterContext(PackedStage& packed, const Target& target, const WriteOptions& options,
                             OtherStages others)
    : program(packed.program()),
      types(program.types),
      target(target),
      needs(target.Needs()),
      options(options),
      others(others),
      reached(std::move(packed.reached)),
      descriptors(program, reached, target, others),
      layouts(std::move(packed.layouts)),
      readers(std::move(packed.readers)),
      used_structs(types.structs().size()) {}

bool WriterContext::IsWrittenAsUint(ir::VarId member) const {
  const ir::Type& type = TypeOf(member);
  if (!type.IsNumeric() || type.scalar != ir::Scalar::kBool || type.kind == ir::TypeKind::kMatrix)
    return false;
  const ir::Cbuffer& cbuffer = (*this)[(*this)[member].cbuffer];
  const auto at = std::ranges::find(cbuffer.members, member, &ir::CbufferMember::var);
  const auto index = static_cast<std::size_t>(at - cbuffer.members.begin());
  return cbuffer.declared && index < cbuffer.declared->members.size()
             ? cbuffer.declared->members[index].is_uint
             : LayoutOf(member).has_uints && !IsByHand(member);
}

const std::string& WriterContext::NameOf(const BlockMember& member) const {
  if (member.field < 0) return NameOf(member.var);
  const ir::Type& type = types[types.Innermost(program.vars[member.var].type)];
  return FieldsOf(type.structure)[static_cast<std::size_t>(member.field)];
}

std::uint32_t RowsRead(const WriterContext& context, const ir::Cbuffer& cbuffer) {
  std::uint32_t end = 0;
  for (const ir::CbufferMember& member : cbuffer.members) {
    if (OnlyFloats(context.types, context[member.var].type) && context.IsReadInProgram(member.var))
      end = std::max(end, member.offset + member.size);
  }
  return (end + kRow - 1) / kRow;
}

const GlslInfo::UniformBlock* WriterContext::LaidBlock(ir::CbufferId id) const {
  for (const OtherStage& other : others) {
    const ir::CbufferId theirs = other.cbuffers[id.index];
    if (theirs && other.laid) return other.laid->BlockOf(theirs);
  }
  return nullptr;
}

const GlslInfo::Object* WriterContext::LaidObject(ir::VarId texture, ir::VarId sampler) const {
  for (const OtherStage& other : others) {
    if (!other.laid) continue;
    const ir::VarId their_texture = texture ? other.vars[texture.index] : ir::VarId{};
    const ir::VarId their_sampler = sampler ? other.vars[sampler.index] : ir::VarId{};
    if (!their_texture != !texture || !their_sampler != !sampler) continue;
    for (const GlslInfo::Object& object : other.laid->objects) {
      if (object.texture == their_texture && object.sampler == their_sampler) return &object;
    }
  }
  return nullptr;
}

void WriterContext::RequireWide(const ir::Type& type) {
  if (!type.IsNumeric()) return;
  if (const Requirement* requirement = RequirementOf(BaseOf(type.scalar)))
    Require(requirement->feature);
}

}  // namespace clipc::glsl
