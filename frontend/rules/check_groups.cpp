// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/check_groups.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "frontend/rules/check_races.h"
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

// Whether all threads of a group come to each wait together, as a short look tells: the group is
// one thread, or each wait is a statement of the entry point's own block, which no `return` leaves.
bool AllWaitTogether(const Program& program) {
  const auto [x, y, z] = program.group_size;
  if (x * y * z == 1) return true;
  std::size_t waits = 0, own = 0;
  bool returns = false;
  program.exprs.ForEach([&](ExprId, const Expr& expr) {
    const auto* call = std::get_if<IntrinsicCall>(&expr.node);
    waits += call && WaitsForGroup(call->op);
  });
  if (waits == 0) return true;
  const StmtId body = program.functions[program.entry].body;
  ForEachStmt(program, body, [&](StmtId id) { returns |= As<Return>(program, id) != nullptr; });
  const auto* block = As<Block>(program, body);
  if (returns || !block) return false;
  for (const StmtId id : program.stmt_lists[block->body]) {
    const auto* evaluate = As<Evaluate>(program, id);
    own += evaluate && Waits(program, evaluate->expr);
  }
  return own == waits;
}

void CheckWaits(const Program& program, Diagnostics& diagnostics) {
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

// Whether the node writes the operand otherwise than by an assignment or an atomic operation.
bool IsOddWrite(const Program& program, ExprId expr, std::size_t operand) {
  const auto* assign = As<Assign>(program, expr);
  const auto* call = As<IntrinsicCall>(program, expr);
  return WritesOperand(program, expr, operand) && !(assign && !assign->op) &&
         !(call && CategoryOf(call->op) == IntrinsicCategory::kAtomic);
}

// Reports uses of floats that atomic operations change which legalize::LowerSharedFloats does not
// translate.
void CheckSharedFloats(const Program& program, Diagnostics& diagnostics) {
  const std::set<VarId> shared = ir::ExchangedFloats(program);
  if (shared.empty()) return;
  std::set<ExprId> odd, longer;  // paths; those that another one goes on from
  std::vector<ExprId> paths;
  const auto is_shared = [&](ExprId expr) {
    const VarId root = RootOf(program, expr);
    return root && shared.contains(root);
  };
  ForEachLiveExpr(program, [&](ExprId expr) {
    if (is_shared(expr)) {
      paths.push_back(expr);
      longer.insert(WholeOf(program, expr));
      if (!As<Index>(program, expr) && !As<VarRef>(program, expr)) odd.insert(expr);
    }
    const std::vector<ExprId> operands = OperandsOf(program, expr);
    for (std::size_t i = 0; i < operands.size(); ++i) {
      if (is_shared(operands[i]) && IsOddWrite(program, expr, i)) odd.insert(operands[i]);
    }
  });
  for (const ExprId path : paths) {
    const bool is_whole = !longer.contains(path) && TypeOf(program, path).kind != TypeKind::kScalar;
    if (is_whole || odd.contains(path))
      diagnostics.Report(program.exprs[path].span, diag::SharedFloatUse,
                         program.vars[RootOf(program, path)].name);
  }
}

// Whether the path names the same element in every thread, or one that is computed: a variable is
// believed to be the thread's own number.
bool IsOfOther(const Program& program, ExprId path) {
  ExprId index = {};
  while (path) {
    if (const auto* step = As<Index>(program, path)) index = step->index;
    path = WholeOf(program, path);
  }
  while (const auto* convert = As<Convert>(program, index)) index = convert->operand;
  return !index || As<Literal>(program, index) || As<Binary>(program, index);
}

// Warns of what the hardware of Direct3D 10 does not do ("Compute Shaders on Downlevel Hardware"):
// several unordered access views, and writes to the memory of other threads.
void CheckDownlevel(const Program& program, Diagnostics& diagnostics) {
  if (program.profile.IsAtLeast(5, 0)) return;
  const std::string& profile = program.profile.name;
  bool has_one = false;
  for (const ir::Resource& resource : program.resources) {
    const Var& var = program.vars[resource.var];
    if (resource.counter_of || !IsWritable(program.types[program.types.Innermost(var.type)].object))
      continue;
    if (has_one) diagnostics.Report(var.span, diag::SecondWritableBuffer, var.name, profile);
    has_one = true;
  }
  ForEachLiveExpr(program, [&](ExprId expr) {
    ForEachWrite(program, expr, [&](ExprId target) {
      const VarId root = RootOf(program, target);
      if (root && program.vars[root].storage == ir::Storage::kShared && IsOfOther(program, target))
        diagnostics.Report(program.exprs[target].span, diag::SharedWriteAtOther,
                           program.vars[root].name, profile);
    });
  });
}

}  // namespace

void CheckGroups(const Program& program, Diagnostics& diagnostics) {
  if (!InfoOf(program.stage).runs_in_groups) return;
  const std::uint64_t most = program.profile.IsAtLeast(5, 0) ? 32768 : 16384;
  if (const std::uint64_t bytes = ir::SharedBytes(program); bytes > most) {
    diagnostics.Report(program.functions[program.entry].span, diag::SharedMemoryTooLarge, bytes,
                       program.profile.name, most);
  }
  if (!AllWaitTogether(program)) {
    CheckWaits(program, diagnostics);
    CheckRaces(program, diagnostics);
  }
  CheckSharedFloats(program, diagnostics);
  CheckDownlevel(program, diagnostics);
}

}  // namespace clipc::rules
