// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/self.h"

#include <algorithm>

#include "base/overloaded.h"
#include "frontend/rules/intrinsics.h"

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
    if (is_new)
      context.functions.changes_self[context[id].decl.index] =
          !decl->body || MayChangeSelf(context, *decl, scope);
    if (context.functions.changes_self[context[id].decl.index]) return true;
  }
  return false;
}

// `this`, a field, or a path from one.
bool IsPartOfSelf(const Context& context, ast::ExprId id, ScopeId scope) {
  const auto& node = context[id].node;
  if (const auto* member = std::get_if<ast::MemberExpr>(&node))
    return IsPartOfSelf(context, member->base, scope);
  if (const auto* index = std::get_if<ast::IndexExpr>(&node))
    return IsPartOfSelf(context, index->base, scope);
  const auto* name = std::get_if<ast::NameExpr>(&node);
  if (!name || !name->name.scopes.empty()) return false;
  if (context[name->name.name] == "this") return true;
  const SymbolId found = context.names.FindNested(scope, name->name.name);
  return found && context[found].kind == SymbolKind::kField;
}

bool ExprChangesSelf(Context& context, ast::ExprId id, ScopeId scope) {
  if (!id) return false;
  const auto expr = [&](ast::ExprId e) { return ExprChangesSelf(context, e, scope); };
  const auto part = [&](ast::ExprId e) { return IsPartOfSelf(context, e, scope); };
  return std::visit(
      Overloaded{
          [&](const ast::UnaryExpr& e) {
            return (e.op >= ast::UnaryOp::kPreIncrement && part(e.operand)) || expr(e.operand);
          },
          [&](const ast::BinaryExpr& e) { return expr(e.left) || expr(e.right); },
          [&](const ast::AssignExpr& e) { return part(e.left) || expr(e.left) || expr(e.right); },
          [&](const ast::ConditionalExpr& e) {
            return expr(e.condition) || expr(e.when_true) || expr(e.when_false);
          },
          [&](const ast::CallExpr& e) {
            const ast::Expr& callee = context[e.callee];
            const auto* name = std::get_if<ast::NameExpr>(&callee.node);
            const auto* member = std::get_if<ast::MemberExpr>(&callee.node);
            if (std::ranges::any_of(context[e.arguments], expr)) return true;
            // A method of the same object, a method of a part of it.
            if (member) return part(member->base);
            if (!name) return false;
            const SymbolId found = context.names.FindNested(scope, name->name.name);
            if (found && context[found].kind == SymbolKind::kFunction &&
                CallChangesSelf(context, found, scope))
              return true;
            const std::string_view text = context[name->name.name];
            const bool writes_nothing =
                IsIntrinsicName(text) && text != "sincos" && text != "modf" && text != "frexp";
            if (writes_nothing && name->name.scopes.empty()) return false;
            // It may have an `out` parameter.
            return std::ranges::any_of(context[e.arguments], part);
          },
          [&](const ast::CastExpr& e) { return expr(e.operand); },
          [&](const ast::IndexExpr& e) { return expr(e.base) || expr(e.index); },
          [&](const ast::MemberExpr& e) { return expr(e.base); },
          [&](const ast::InitListExpr& e) {
            return std::ranges::any_of(context[e.elements], expr);
          },
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

}  // namespace

bool MayChangeSelf(Context& context, const ast::FunctionDecl& decl, ScopeId scope) {
  return decl.body && !decl.is_const_method && StmtChangesSelf(context, decl.body, scope);
}

}  // namespace clipc::check
