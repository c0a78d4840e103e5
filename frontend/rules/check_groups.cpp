// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/check_groups.h"

#include <cstdint>

#include "frontend/rules/varying_flow.h"
#include "ir/access.h"
#include "ir/shared_memory.h"

namespace clipc::rules {
namespace {

// Whether the input may have several values in the threads of a group.
bool DiffersInGroup(const Program&, const IoVar& input) {
  return input.builtin != Builtin::kGroupId && input.builtin != Builtin::kLaneCount;
}

// Whether the node gives threads different values: the value before an atomic operation, and what
// each wave has by itself.
bool GivesThreadsDifferent(const Program& program, ExprId expr) {
  const auto* object = As<ObjectCall>(program, expr);
  const auto* call = As<IntrinsicCall>(program, expr);
  return (object && IsAtomic(object->op)) ||
         (call && (CategoryOf(call->op) == IntrinsicCategory::kAtomic ||
                   CategoryOf(call->op) == IntrinsicCategory::kWave ||
                   CategoryOf(call->op) == IntrinsicCategory::kQuad));
}

bool Waits(const Program& program, ExprId expr) {
  const auto* call = As<IntrinsicCall>(program, expr);
  return call && WaitsForGroup(call->op);
}

void CheckWaits(const Program& program, Diagnostics& diagnostics) {
  const auto [x, y, z] = program.group_size;
  if (x * y * z == 1) return;  // there is nobody to wait for
  const bool is_error = !program.profile.IsAtLeast(6, 0);
  for (const AskedNode& node :
       FollowFlow(program, {DiffersInGroup, GivesThreadsDifferent, Waits})) {
    if (!node.flow_varies && !node.loop_varies) continue;
    const char* name = NameOf(std::get<IntrinsicCall>(program.exprs[node.expr].node).op);
    const Span span = program.exprs[node.expr].span;
    if (is_error)
      diagnostics.Report(span, diag::WaitInVaryingFlow, name);
    else
      diagnostics.Report(span, diag::WaitMayHang, name);
  }
}

}  // namespace

void CheckGroups(const Program& program, Diagnostics& diagnostics) {
  if (!InfoOf(program.stage).runs_in_groups) return;
  const std::uint64_t most = program.profile.IsAtLeast(5, 0) ? 32768 : 16384;
  if (const std::uint64_t bytes = ir::SharedBytes(program); bytes > most) {
    diagnostics.Report(program.functions[program.entry].span, diag::SharedMemoryTooLarge, bytes,
                       program.profile.name, most);
  }
  CheckWaits(program, diagnostics);
}

}  // namespace clipc::rules
