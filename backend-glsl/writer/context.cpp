// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/context.h"

#include <algorithm>

#include "backend-glsl/needs.h"

namespace clipc::glsl {

namespace {

std::vector<BlockLayout> LayOutBlocks(const ir::Program& program, const Reached& reached,
                                      const Target& target, BlockStyle style) {
  std::vector<BlockLayout> layouts(program.cbuffers.size());
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    if (reached.Has(id))
      layouts[id.index] = LayOutBlock(program, program.cbuffers[id], target, style, reached.vars);
  }
  return layouts;
}

}  // namespace

Context::Context(const ir::Program& program, const Target& target, const WriteOptions& options)
    : program(program),
      types(program.types),
      target(target),
      options(options),
      reached(Reach(program)),
      descriptors(program, reached, target),
      layouts(LayOutBlocks(program, reached, target, options.blocks)),
      used_structs(types.structs().size()) {}

bool Context::IsWrittenAsUint(ir::VarId member) const {
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

void Context::RequireType(const ir::Type& type) {
  if (!type.IsNumeric()) return;
  if (const Need* need = NeedOf(BaseOf(type.scalar))) Require(need->feature);
}

}  // namespace clipc::glsl
