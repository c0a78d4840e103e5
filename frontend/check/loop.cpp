// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/loop.h"

#include <algorithm>
#include <utility>

#include "frontend/check/emit.h"
#include "frontend/check/expr.h"
#include "frontend/check/flow.h"
#include "frontend/check/scope.h"
#include "frontend/check/stmt.h"
#include "frontend/rules/loop_iterations.h"

namespace clipc::check {
namespace {

StmtId CheckLoopBody(Context& context, ast::StmtId body) {
  ++context.view.body->loops;
  const bool was_in_switch = std::exchange(context.view.body->is_in_switch, false);
  const StmtId block = CheckBlock(context, body);
  context.view.body->is_in_switch = was_in_switch;
  --context.view.body->loops;
  return block;
}

void CheckForInit(Context& context, ast::StmtId init, For& loop) {
  const std::size_t mark = context.stmts.size();
  if (const auto* stmt = context.GetIf<ast::ExprStmt>(init)) {
    const ExprId value = CheckExpr(context, stmt->expr);
    const ExprId kept = WithoutString(context, value);
    if (!kept || context.IsError(value)) return;
    DeclareTemporaries(context);
    loop.init = context.program.stmt_lists.Add({context.At(context[init].span).Eval(kept)});
    return;
  }
  CheckStmt(context, init);
  const std::span<const StmtId> emitted = std::span<const StmtId>(context.stmts).subspan(mark);
  if (emitted.empty()) return;
  const auto type_of = [&](StmtId id) {
    const auto* declare = context.GetIf<Declare>(id);
    return declare ? context[declare->var].type : TypeId{};
  };
  const TypeId type = type_of(emitted.front());
  const bool one_type =
      type && std::ranges::all_of(emitted, [&](StmtId id) { return type_of(id) == type; });
  // Other statements are left before the loop.
  if (!one_type) return;
  loop.init = TakeStmts(context, mark);
}

}  // namespace

void CheckNode(Context& context, const ast::ForStmt& stmt, Span span) {
  std::vector<SymbolId> variables;
  For loop;
  {
    const ScopeTable::LocalScope scope(context.names);
    const std::size_t mark = context.names.locals().size();
    if (stmt.init) CheckForInit(context, stmt.init, loop);
    const std::span<const SymbolId> declared = context.names.locals().subspan(mark);
    variables.assign(declared.begin(), declared.end());
    if (stmt.condition) loop.condition = CheckCondition(context, stmt.condition, "for");
    if (stmt.step) loop.step = WithoutString(context, CheckExpr(context, stmt.step));
    DeclareTemporaries(context);
    loop.body = CheckLoopBody(context, stmt.body);
  }
  Emit(context, span, loop);
  if (context.options.scopes_loops) {
    std::vector<SymbolId>& ended = context.view.body->ended;
    ended.insert(ended.end(), variables.begin(), variables.end());
    return;
  }
  // In fxc the variables are visible after the loop (it warns of conflicts with X3078).
  for (SymbolId id : variables) {
    const Symbol variable = context[id];
    const SymbolId hidden = context.names.InnermostLocal(variable.name);
    if (hidden && hidden.index >= context.view.local_floor && !context[hidden].is_leaked) continue;
    const SymbolId leaked =
        DeclareLocal(context, variable.kind, variable.name, variable.decl, variable.span);
    context[leaked].is_leaked = true;
    context[leaked].Resolve(variable.value);
    context[leaked].owner = context.stmts.back().index;
  }
}

void HoistLoopVariable(Context& context, SymbolId id) {
  Symbol& symbol = context[id];
  if (symbol.owner == ~0u) return;
  auto& loop = context.Get<For>(StmtId{symbol.owner});
  symbol.owner = ~0u;
  ExprId assignments;
  const std::vector<StmtId> init(context[loop.init].begin(), context[loop.init].end());
  for (StmtId stmt : init) {
    const auto* declare = context.GetIf<Declare>(stmt);
    if (!declare) return;
    const VarId var = declare->var;
    const ExprId value = declare->init;
    Builder at = context.At(context[var].span);
    context.view.body->hoisted.push_back(at.Stmt(Declare{var, {}}));
    if (!value) continue;
    const ExprId assignment = at.AssignTo(at.Ref(var), value);
    assignments = assignments ? at.CommaOf(assignments, assignment) : assignment;
  }
  loop.init = {};
  if (assignments)
    loop.init =
        context.program.stmt_lists.Add({context.At(context[assignments].span).Eval(assignments)});
}

void CheckNode(Context& context, const ast::WhileStmt& stmt, Span span) {
  const ExprId condition = CheckCondition(context, stmt.condition, "while");
  DeclareTemporaries(context);
  const StmtId body = CheckLoopBody(context, stmt.body);
  Emit(context, span, While{condition, body});
}

void CheckNode(Context& context, const ast::DoStmt& stmt, Span span) {
  const StmtId body = CheckLoopBody(context, stmt.body);
  const ExprId condition = CheckCondition(context, stmt.condition, "while");
  Emit(context, span, DoWhile{body, condition});
}

void CheckIterations(Context& context, StmtId loop, Span span, Hint hint) {
  if (hint != Hint::kUnroll && NeverEnds(context, loop)) {
    context.Report(span, diag::EndlessLoop);
    return;
  }
  const auto* counted = context.GetIf<For>(loop);
  const bool is_named = hint == Hint::kNone && !context.program.profile.IsAtLeast(6, 0);
  if (counted && is_named && RunsAtMostOnce(context.program, *counted))
    context.Report(span, diag::LoopRunsOnce);
}

}  // namespace clipc::check
