// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/driver_bugs.h"

#include <algorithm>
#include <variant>

#include "tools/harness/offscreen.h"

namespace clipc::draw::vulkan {
namespace {

using namespace ir;

bool IsArrayOfArrays(const TypeTable& types, TypeId id) {
  return types[id].kind == TypeKind::kArray && types[types[id].element].kind == TypeKind::kArray;
}

// Whether the call is a gather with four offsets. No other call has seven arguments (texture,
// sampler, coordinate, and four offsets).
bool HasFourOffsets(const Program& program, const ObjectCall& call) {
  return TakesSampler(call.op) && program.expr_lists[call.arguments].size() == 7;
}

// Whether the object is an element of an array, or another texture has a lower register.
bool MayNotBeTheFirst(const Program& program, ExprId object) {
  const auto* ref = std::get_if<VarRef>(&program.exprs[object].node);
  if (!ref) return true;
  const auto register_of = [](const Resource& resource) {
    return std::pair(resource.reg.space, resource.reg.number);
  };
  const auto self = std::ranges::find(program.resources, ref->var, &Resource::var);
  return std::ranges::any_of(program.resources, [&](const Resource& other) {
    return other.reg.letter == 't' && register_of(other) < register_of(*self);
  });
}

}  // namespace

void RefuseDriverBugs(const Program& program) {
  for (const Resource& resource : program.resources) {
    if (!IsArrayOfArrays(program.types, program.vars[resource.var].type)) continue;
    throw harness::DrawError("an array of arrays of textures, which lavapipe does not read");
  }
  for (const ExprId id : program.exprs.ids()) {
    const auto* call = std::get_if<ObjectCall>(&program.exprs[id].node);
    if (!call || !HasFourOffsets(program, *call) ||
        !MayNotBeTheFirst(program, program.expr_lists[call->arguments][0]))
      continue;
    throw harness::DrawError(
        "a gather with four offsets, which lavapipe reads from another texture");
  }
}

}  // namespace clipc::draw::vulkan
