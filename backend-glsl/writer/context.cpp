// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/context.h"

#include <algorithm>

#include "backend-glsl/requirements.h"

namespace clipc::glsl {

namespace {

std::vector<BlockLayout> LayOutBlocks(const ir::Program& program, const Reached& reached,
                                      const Target& target, const WriteOptions& options,
                                      const OtherStage* other) {
  std::vector<BlockLayout> layouts(program.cbuffers.size());
  // The two stages lay out a block that they share by what either of them reads.
  std::vector<bool> is_read = reached.vars;
  for (std::size_t i = 0; other && i < is_read.size(); ++i)
    is_read[i] = is_read[i] || other->is_read[i];
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    if (reached.Has(id))
      layouts[id.index] =
          LayOutBlock(program, program.cbuffers[id], target, options.blocks, is_read);
  }
  return layouts;
}

}  // namespace

WriterContext::WriterContext(const ir::Program& program, const Target& target,
                             const WriteOptions& options, const OtherStage* other)
    : program(program),
      types(program.types),
      target(target),
      needs(target.Needs()),
      options(options),
      other(other),
      reached(Reach(program)),
      descriptors(program, reached, target, other),
      layouts(LayOutBlocks(program, reached, target, options, other)),
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

const GlslInfo::UniformBlock* WriterContext::LaidBlock(ir::CbufferId id) const {
  return IsShared(id) && other->laid ? other->laid->BlockOf(other->cbuffers[id.index]) : nullptr;
}

const GlslInfo::Object* WriterContext::LaidObject(ir::VarId texture, ir::VarId sampler) const {
  if (!other || !other->laid) return nullptr;
  const auto& alike = other->vars;
  const ir::VarId their_texture = texture ? alike[texture.index] : ir::VarId{};
  const ir::VarId their_sampler = sampler ? alike[sampler.index] : ir::VarId{};
  if (!their_texture != !texture || !their_sampler != !sampler) return nullptr;
  for (const GlslInfo::Object& object : other->laid->objects) {
    if (object.texture == their_texture && object.sampler == their_sampler) return &object;
  }
  return nullptr;
}

void WriterContext::RequireWide(const ir::Type& type) {
  if (!type.IsNumeric()) return;
  if (const Requirement* requirement = RequirementOf(BaseOf(type.scalar)))
    Require(requirement->feature);
}

}  // namespace clipc::glsl
