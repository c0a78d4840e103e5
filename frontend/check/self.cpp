// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/self.h"

#include <algorithm>
#include <vector>

#include "base/overloaded.h"
#include "frontend/parse/ast_walk.h"
#include "frontend/typing/intrinsics.h"
#include "ir/access.h"
#include "ir/call_order.h"
#include "ir/walk.h"

namespace clipc::check {
namespace {

// Whether a call of the method `id` on the same object may change it. The answers are kept.
bool CallChangesSelf(Context& context, SymbolId id, ScopeId scope) {
  for (; id; id = context[id].older) {
    const auto* decl =
        context[id].decl ? context.GetIf<ast::FunctionDecl>(context[id].decl) : nullptr;
    if (!decl || (decl->qualifiers & ast::kStatic)) continue;
    const auto [known, is_new] =
        context.functions.changes_self.try_emplace(context[id].decl.index, false);
    bool& changes = known->second;
    if (is_new) changes = !decl->body || MayChangeSelf(context, *decl, scope);
    if (changes) return true;
  }
  return false;
}

// What the struct has of the name that is written after a struct, B::v or B<T>::v.
SymbolId MemberNamed(const Context& context, Name name, ScopeId scope, SymbolKind kind) {
  const SymbolId found = context.names.FindNested(scope, name);
  return found && context[found].kind == kind ? found : SymbolId{};
}

// Whether the expression is `this`, a field, or a path from one of them.
bool IsPartOfSelf(const Context& context, ast::ExprId id, ScopeId scope) {
  const auto& node = context[id].node;
  if (const auto* member = std::get_if<ast::MemberExpr>(&node)) {
    if (context.Is<ast::TypeExpr>(member->base))
      return bool(MemberNamed(context, member->name, scope, SymbolKind::kField));
    return IsPartOfSelf(context, member->base, scope);
  }
  if (const auto* index = std::get_if<ast::IndexExpr>(&node))
    return IsPartOfSelf(context, index->base, scope);
  const auto* name = std::get_if<ast::NameExpr>(&node);
  if (!name) return false;
  if (context[name->name.name] == "this") return true;
  return bool(MemberNamed(context, name->name.name, scope, SymbolKind::kField));
}

// Whether the call itself may change the object or a part of it; its operands may, too.
bool CallChangesSelf(Context& context, const ast::CallExpr& call, ScopeId scope) {
  const auto part = [&](ast::ExprId e) { return IsPartOfSelf(context, e, scope); };
  // The callee is a method of a part of the object, or else a method of the object.
  const auto* member = context.GetIf<ast::MemberExpr>(call.callee);
  if (member && context.Is<ast::TypeExpr>(member->base)) {
    const SymbolId own = MemberNamed(context, member->name, scope, SymbolKind::kFunction);
    return own && CallChangesSelf(context, own, scope);
  }
  if (member) return part(member->base);
  const auto* name = context.GetIf<ast::NameExpr>(call.callee);
  if (!name) return false;
  const SymbolId found = context.names.FindNested(scope, name->name.name);
  if (found && context[found].kind == SymbolKind::kFunction &&
      CallChangesSelf(context, found, scope))
    return true;
  const std::string_view text = context[name->name.name];
  const bool writes_nothing = IsIntrinsicName(text) && !IsWritingIntrinsic(text);
  if (writes_nothing && name->name.scopes.empty()) return false;
  // The function may have an `out` parameter.
  return std::ranges::any_of(context[call.arguments], part);
}

bool ExprChangesSelf(Context& context, ast::ExprId id, ScopeId scope) {
  if (!id) return false;
  const auto expr = [&](ast::ExprId e) { return ExprChangesSelf(context, e, scope); };
  const auto part = [&](ast::ExprId e) { return IsPartOfSelf(context, e, scope); };
  bool changes = false;
  ast::ForEachChild(context[id].node,
                    Overloaded{
                        [&](ast::ExprId child) { changes = changes || expr(child); },
                        [&](List<ast::ExprId> children) {
                          changes = changes || std::ranges::any_of(context[children], expr);
                        },
                        [](ast::TypeId) {},
                    });
  return changes ||
         Visit(Overloaded{
                   [&](const ast::UnaryExpr& e) {
                     return e.op && ChangesOperand(*e.op) && part(e.operand);
                   },
                   [&](const ast::AssignExpr& e) { return part(e.left); },
                   [&](const ast::CallExpr& e) { return CallChangesSelf(context, e, scope); },
                   [](const auto&) { return false; },
               },
               context[id].node);
}

bool StmtChangesSelf(Context& context, ast::StmtId id, ScopeId scope) {
  if (!id) return false;
  const auto expr = [&](ast::ExprId e) { return e && ExprChangesSelf(context, e, scope); };
  const auto stmt = [&](ast::StmtId s) { return StmtChangesSelf(context, s, scope); };
  return std::visit(
      Overloaded{
          [&](const ast::BlockStmt& s) { return std::ranges::any_of(context[s.body], stmt); },
          [&](const ast::DeclStmt& s) {
            return std::ranges::any_of(context[s.decls], [&](ast::DeclId decl) {
              const auto* var = context.GetIf<ast::VarDecl>(decl);
              return var && expr(var->init);
            });
          },
          [&](const ast::ExprStmt& s) { return expr(s.expr); },
          [&](const ast::IfStmt& s) {
            return expr(s.condition) || stmt(s.then) || stmt(s.otherwise);
          },
          [&](const ast::ForStmt& s) {
            return stmt(s.init) || expr(s.condition) || expr(s.step) || stmt(s.body);
          },
          [&](const ast::WhileStmt& s) { return expr(s.condition) || stmt(s.body); },
          [&](const ast::DoStmt& s) { return stmt(s.body) || expr(s.condition); },
          [&](const ast::SwitchStmt& s) { return expr(s.value) || stmt(s.body); },
          [&](const ast::ReturnStmt& s) { return expr(s.value); },
          [](const auto&) { return false; },
      },
      context[id].node);
}

// The parameters that a call changes, a mark for each VarId, among marks of other variables.
std::vector<bool> ChangedVariables(const Program& program) {
  std::vector<bool> changed(program.vars.size());
  const auto change = [&](ExprId target) {
    if (const VarId root = RootOf(program, target)) changed[root.index] = true;
  };
  for (const FunctionId function : ir::CalleesFirst(program)) {
    ForEachExpr(program, program.functions[function].body, [&](ExprId expr) {
      const auto* call = As<Call>(program, expr);
      if (!call) return ForEachWrite(program, expr, change);
      const std::vector<VarId>& parameters = program.functions[call->function].parameters;
      for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (program.vars[parameters[i]].storage == Storage::kOut || changed[parameters[i].index])
          change(program.expr_lists[call->arguments][i]);
      }
    });
  }
  return changed;
}

}  // namespace

void CheckUniformCalls(Context& context) {
  if (context.functions.uniform_calls.empty()) return;
  const Program& program = context.program;
  const std::vector<bool> changed = ChangedVariables(program);
  for (const auto& [method, uniform, span] : context.functions.uniform_calls) {
    const VarId self = program.functions[method].parameters.front();
    if (changed[self.index])
      context.Report(span, diag::UniformAssigned, program.vars[uniform].name);
  }
}

bool MayChangeSelf(Context& context, const ast::FunctionDecl& decl, ScopeId scope) {
  return decl.body && !decl.is_const_method && StmtChangesSelf(context, decl.body, scope);
}

}  // namespace clipc::check
