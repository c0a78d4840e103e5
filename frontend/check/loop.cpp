// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/loop.h"

#include <algorithm>

#include "frontend/check/emit.h"
#include "frontend/check/expr.h"
#include "frontend/check/scope.h"
#include "frontend/check/stmt.h"

namespace clipc::check {
namespace {

ir::StmtId CheckLoopBody(Context& context, ast::StmtId body) {
  ++context.view.body->loops;
  const ir::StmtId block = CheckBlock(context, body);
  --context.view.body->loops;
  return block;
}

void CheckForInit(Context& context, ast::StmtId init, ir::For& loop) {
  const std::size_t mark = context.stmts.size();
  if (const auto* stmt = context.GetIf<ast::ExprStmt>(init)) {
    const ir::ExprId value = CheckExpr(context, stmt->expr);
    if (context.IsError(value)) return;
    DeclareTemporaries(context);
    loop.init = context.program.stmt_lists.Add({context.At(context[init].span).Eval(value)});
    return;
  }
  CheckStmt(context, init);
  const std::span<const ir::StmtId> emitted =
      std::span<const ir::StmtId>(context.stmts).subspan(mark);
  if (emitted.empty()) return;
  const auto type_of = [&](ir::StmtId id) {
    const auto* declare = context.GetIf<ir::Declare>(id);
    return declare ? context[declare->var].type : ir::TypeId{};
  };
  const ir::TypeId type = type_of(emitted.front());
  const bool one_type =
      type && std::ranges::all_of(emitted, [&](ir::StmtId id) { return type_of(id) == type; });
  // Other statements stay before the loop.
  if (!one_type) return;
  const std::vector<ir::StmtId> stmts = TakeStmts(context, mark);
  loop.init = context.program.stmt_lists.Add(std::span<const ir::StmtId>(stmts));
}

}  // namespace

void CheckFor(Context& context, const ast::ForStmt& stmt, Span span) {
  std::vector<SymbolId> variables;
  ir::For loop;
  {
    const ScopeTable::LocalScope scope(context.names);
    const std::size_t mark = context.names.locals().size();
    if (stmt.init) CheckForInit(context, stmt.init, loop);
    const std::span<const SymbolId> declared = context.names.locals().subspan(mark);
    variables.assign(declared.begin(), declared.end());
    if (stmt.condition) loop.condition = CheckCondition(context, stmt.condition, "for");
    if (stmt.step) loop.step = CheckExpr(context, stmt.step);
    DeclareTemporaries(context);
    loop.body = CheckLoopBody(context, stmt.body);
  }
  Emit(context, span, loop);
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
  auto& loop = context.Get<ir::For>(ir::StmtId{symbol.owner});
  symbol.owner = ~0u;
  ir::ExprId assignments;
  const std::vector<ir::StmtId> init(context[loop.init].begin(), context[loop.init].end());
  for (ir::StmtId stmt : init) {
    const auto* declare = context.GetIf<ir::Declare>(stmt);
    if (!declare) return;
    const ir::VarId var = declare->var;
    const ir::ExprId value = declare->init;
    ir::Builder at = context.At(context[var].span);
    context.view.body->hoisted.push_back(at.Stmt(ir::Declare{var, {}}));
    if (!value) continue;
    const ir::ExprId assignment = at.AssignTo(at.Ref(var), value);
    assignments = assignments ? at.CommaOf(assignments, assignment) : assignment;
  }
  loop.init = {};
  if (assignments)
    loop.init =
        context.program.stmt_lists.Add({context.At(context[assignments].span).Eval(assignments)});
}

void CheckWhile(Context& context, const ast::WhileStmt& stmt, Span span) {
  const ir::ExprId condition = CheckCondition(context, stmt.condition, "while");
  DeclareTemporaries(context);
  const ir::StmtId body = CheckLoopBody(context, stmt.body);
  Emit(context, span, ir::While{condition, body});
}

void CheckDo(Context& context, const ast::DoStmt& stmt, Span span) {
  const ir::StmtId body = CheckLoopBody(context, stmt.body);
  const ir::ExprId condition = CheckCondition(context, stmt.condition, "while");
  Emit(context, span, ir::DoWhile{body, condition});
}

}  // namespace clipc::check
