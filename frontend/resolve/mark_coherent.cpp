// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/mark_coherent.h"

#include <vector>

#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::resolve {

void MarkCoherent(Program& program) {
  const auto orders_objects = [](const IntrinsicCall& call) {
    return BarrierOf(call.op).orders_objects;
  };
  if (!InfoOf(program.stage).runs_in_groups || !MayHaveExpr<IntrinsicCall>(program, orders_objects))
    return;
  struct Use {
    bool is_loaded = false, is_stored = false, is_atomic = false;
  };
  std::vector<Use> uses(program.vars.size());
  bool has_barrier = false;
  ForEachLiveExpr(program, [&](ExprId expr) {
    if (const auto* call = As<IntrinsicCall>(program, expr)) has_barrier |= orders_objects(*call);
    const auto* access = As<ObjectCall>(program, expr);
    if (!access) return;
    Use& use = uses[RootOf(program, OperandOf(program, *access, OperandKind::kObject)).index];
    use.is_loaded |= HasTrait(access->op, ObjectOpInfo::kReads);
    use.is_stored |= HasTrait(access->op, ObjectOpInfo::kWrites);
    use.is_atomic |= IsAtomic(access->op);
  });
  if (!has_barrier) return;
  for (const Resource& resource : program.resources) {
    const Use& use = uses[resource.var.index];
    const int kinds = use.is_loaded + use.is_stored + use.is_atomic;
    if (kinds > 1) program.vars[resource.var].coherent = true;
  }
}

}  // namespace clipc::resolve
