// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/driver_bugs.h"

#include <algorithm>
#include <variant>

#include "ir/access.h"
#include "tools/harness/offscreen.h"

namespace clipc::draw::vulkan {
namespace {

using namespace ir;

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
  for (const ExprId id : program.exprs.ids()) {
    const auto* call = std::get_if<ObjectCall>(&program.exprs[id].node);
    const bool is_gather_of_four = call && OperandsOf(*call, OperandKind::kOffset).size == 4;
    if (!is_gather_of_four ||
        !MayNotBeTheFirst(program, OperandOf(program, *call, OperandKind::kObject)))
      continue;
    throw harness::DrawError(
        "a gather with four offsets, which lavapipe reads from another texture");
  }
}

}  // namespace clipc::draw::vulkan
