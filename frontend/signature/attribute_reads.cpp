// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/attribute_reads.h"

#include <algorithm>
#include <variant>

#include "base/spelling.h"

namespace clipc::signature {

VarId AttributeReads::InputOf(const SemanticName& semantic) const {
  const auto known = std::ranges::find_if(program_.inputs, [&](const IoVar& input) {
    return input.builtin == Builtin::kNone && input.index == semantic.index &&
           EqualIgnoringCase(input.semantic, semantic.name);
  });
  return known == program_.inputs.end() ? VarId{} : known->var;
}

ExprId AttributeReads::Read(VarId input, std::uint32_t count) {
  TypeTable& types = program_.types;
  TypeId& type = program_.vars[input].type;
  const Scalar kind = types[type].scalar;
  const TypeId part = count == 1 ? types.Make(kind) : types.Vector(kind, static_cast<int>(count));
  // A vector of one component is a number from then on.
  if (count >= types[type].Components()) type = part;
  return reads_.emplace_back(builder_.Add(part, VarRef{input}));
}

void AttributeReads::Finish() {
  for (const ExprId value : reads_) {
    const VarId input = std::get<VarRef>(program_.exprs[value].node).var;
    const std::uint32_t count = program_.types[builder_.TypeOf(value)].Components();
    if (count == program_.types[program_.vars[input].type].Components()) continue;
    const ExprId part = builder_.SwizzledRun(builder_.Ref(input), 0, count);
    program_.exprs[value].node = program_.exprs[part].node;
  }
}

bool IsClampedOutput(const Program& program, std::string_view semantic, const Type& type) {
  const Profile& profile = program.profile;
  return profile.IsDirect3D9() && !profile.IsAtLeast(3, 0) && program.stage == Stage::kVertex &&
         (EqualIgnoringCase(semantic, "COLOR") || EqualIgnoringCase(semantic, "FOG")) &&
         BaseOf(type.scalar) == Scalar::kFloat;
}

}  // namespace clipc::signature
