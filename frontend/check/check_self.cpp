// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "base/overloaded.h"
#include "frontend/check/checker.h"
#include "frontend/rules/intrinsics.h"

// Which methods change the object they are called on. Those that do take it `inout`, the others
// `in`. The text decides, before any name of the body is resolved, so the answer may be "yes" where
// "no" would do.
namespace clipc {

bool Checker::MayChangeSelf(const ast::FunctionDecl& decl, ScopeId scope) {
  return decl.body && !decl.is_const_method && StmtChangesSelf(decl.body, scope);
}

// Whether a call of the method `id` on the same object may change it. Each method is looked at
// once.
bool Checker::CallChangesSelf(SymbolId id, ScopeId scope) {
  for (; id; id = symbols_[id].older) {
    const auto* decl = symbols_[id].decl
                           ? std::get_if<ast::FunctionDecl>(&file_.decls[symbols_[id].decl].node)
                           : nullptr;
    if (!decl || (decl->qualifiers & ast::kStatic)) continue;
    const auto [known, is_new] = changes_self_.try_emplace(symbols_[id].decl.index, false);
    if (is_new) changes_self_[symbols_[id].decl.index] = !decl->body || MayChangeSelf(*decl, scope);
    if (changes_self_[symbols_[id].decl.index]) return true;
  }
  return false;
}

bool Checker::StmtChangesSelf(ast::StmtId id, ScopeId scope) {
  if (!id) return false;
  const auto expr = [&](ast::ExprId e) { return e && ExprChangesSelf(e, scope); };
  const auto stmt = [&](ast::StmtId s) { return StmtChangesSelf(s, scope); };
  return std::visit(
      Overloaded{
          [&](const ast::BlockStmt& s) {
            return std::ranges::any_of(file_.stmt_lists[s.body], stmt);
          },
          [&](const ast::DeclStmt& s) {
            return std::ranges::any_of(file_.decl_lists[s.decls], [&](ast::DeclId decl) {
              const auto* var = std::get_if<ast::VarDecl>(&file_.decls[decl].node);
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
      file_.stmts[id].node);
}

bool Checker::ExprChangesSelf(ast::ExprId id, ScopeId scope) {
  if (!id) return false;
  const auto expr = [&](ast::ExprId e) { return ExprChangesSelf(e, scope); };
  const auto part = [&](ast::ExprId e) { return IsPartOfSelf(e, scope); };
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
            const ast::Expr& callee = file_.exprs[e.callee];
            const auto* name = std::get_if<ast::NameExpr>(&callee.node);
            const auto* member = std::get_if<ast::MemberExpr>(&callee.node);
            if (std::ranges::any_of(file_.expr_lists[e.arguments], expr)) return true;
            // A method of the same object, a method of a part of it.
            if (member) return part(member->base);
            if (!name) return false;
            const SymbolId found = FindNested(scope, name->name.name, false, 0);
            if (found && symbols_[found].kind == SymbolKind::kFunction &&
                CallChangesSelf(found, scope))
              return true;
            const std::string_view text = Text(name->name.name);
            const bool writes_nothing =
                IsIntrinsicName(text) && text != "sincos" && text != "modf" && text != "frexp";
            if (writes_nothing && name->name.scopes.empty()) return false;
            // It may have an `out` parameter.
            return std::ranges::any_of(file_.expr_lists[e.arguments], part);
          },
          [&](const ast::CastExpr& e) { return expr(e.operand); },
          [&](const ast::IndexExpr& e) { return expr(e.base) || expr(e.index); },
          [&](const ast::MemberExpr& e) { return expr(e.base); },
          [&](const ast::InitListExpr& e) {
            return std::ranges::any_of(file_.expr_lists[e.elements], expr);
          },
          [](const auto&) { return false; },
      },
      file_.exprs[id].node);
}

// `this`, a field, or a path from one.
bool Checker::IsPartOfSelf(ast::ExprId id, ScopeId scope) const {
  const auto& node = file_.exprs[id].node;
  if (const auto* member = std::get_if<ast::MemberExpr>(&node))
    return IsPartOfSelf(member->base, scope);
  if (const auto* index = std::get_if<ast::IndexExpr>(&node))
    return IsPartOfSelf(index->base, scope);
  const auto* name = std::get_if<ast::NameExpr>(&node);
  if (!name || !name->name.scopes.empty()) return false;
  if (Text(name->name.name) == "this") return true;
  const SymbolId found = FindNested(scope, name->name.name, false, 0);
  return found && symbols_[found].kind == SymbolKind::kField;
}

}  // namespace clipc
