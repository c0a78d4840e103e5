// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/static_effects.h"

#include <algorithm>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/overloaded.h"
#include "frontend/check/body.h"
#include "frontend/check/global.h"
#include "frontend/check/type_names.h"
#include "frontend/parse/ast_walk.h"
#include "frontend/typing/intrinsics.h"
#include "ir/access.h"

namespace clipc::check {
namespace {

// Calls visit(ExprId) for each expression directly in the statement and in those inside it.
template <typename OnExpr>
void ForEachExprIn(const Context& context, ast::StmtId id, const OnExpr& visit) {
  if (!id) return;
  const auto stmt = [&](ast::StmtId s) { ForEachExprIn(context, s, visit); };
  const auto expr = [&](ast::ExprId e) {
    if (e) visit(e);
  };
  Visit(Overloaded{
            [&](const ast::BlockStmt& s) { std::ranges::for_each(context[s.body], stmt); },
            [&](const ast::DeclStmt& s) {
              for (const ast::DeclId decl : context[s.decls]) {
                if (const auto* var = context.GetIf<ast::VarDecl>(decl)) expr(var->init);
              }
            },
            [&](const ast::ExprStmt& s) { expr(s.expr); },
            [&](const ast::IfStmt& s) { expr(s.condition), stmt(s.then), stmt(s.otherwise); },
            [&](const ast::ForStmt& s) {
              stmt(s.init), expr(s.condition), expr(s.step), stmt(s.body);
            },
            [&](const ast::WhileStmt& s) { expr(s.condition), stmt(s.body); },
            [&](const ast::DoStmt& s) { stmt(s.body), expr(s.condition); },
            [&](const ast::SwitchStmt& s) { expr(s.value), stmt(s.body); },
            [&](const ast::ReturnStmt& s) { expr(s.value); },
            [](const auto&) {},
        },
        context[id].node);
}

// Whether the node is one that an operator of the file may be called for.
bool MayCallOperator(const Context& context, ast::ExprId id) {
  return !context.functions.operators.empty() &&
         (context.Is<ast::UnaryExpr>(id) || context.Is<ast::BinaryExpr>(id) ||
          context.Is<ast::IndexExpr>(id) || context.Is<ast::CallExpr>(id));
}

// What the text of an expression or of functions changes and calls.
struct Deeds {
  std::vector<Name> changed;  // where the paths begin that are changed
  std::vector<Name> called;   // the functions and methods
};

// The search of the text for what an initial value changes. It knows names only, so that it may
// find an effect where there is none.
class EffectSearch {
 public:
  explicit EffectSearch(const Context& context)
      : context_(context), is_kept_(context.file.names.size()) {
    for (const ast::DeclId id : context.file.decls.ids()) {
      const auto* function = context.GetIf<ast::FunctionDecl>(id);
      if (function) functions_[function->name.index].push_back(function);
      const auto* var = context.GetIf<ast::VarDecl>(id);
      if (var && var->type && IsWritableObjectName(context[context[var->type].name.name]))
        is_kept_[var->name.index] = true;
    }
  }

  // Notes the static variables that have been reached: changing one is an effect from here on.
  void NoteReached() {
    for (const SymbolId id : context_.names.symbol_ids()) {
      const Symbol& symbol = context_[id];
      if (symbol.kind != SymbolKind::kVariable || symbol.value == ~0u || !symbol.decl) continue;
      const auto* var = context_.GetIf<ast::VarDecl>(symbol.decl);
      if (var && (var->qualifiers & (ast::kStatic | ast::kGroupShared)))
        is_kept_[symbol.name.index] = true;
    }
  }

  // Whether the expression, or a function that it calls, changes a variable that counts.
  bool HasEffect(ast::ExprId id) {
    Deeds own;
    Collect(id, own);
    if (Changes(own)) return true;
    std::vector<bool> is_seen(is_kept_.size());
    std::vector<Name> waiting = std::move(own.called);
    while (!waiting.empty()) {
      const Name name = waiting.back();
      waiting.pop_back();
      if (is_seen[name.index]) continue;
      is_seen[name.index] = true;
      const Deeds& deeds = DeedsOf(name);
      if (Changes(deeds)) return true;
      waiting.insert(waiting.end(), deeds.called.begin(), deeds.called.end());
    }
    return false;
  }

 private:
  bool Changes(const Deeds& deeds) const {
    return std::ranges::any_of(deeds.changed, [&](Name name) { return is_kept_[name.index]; });
  }

  const Deeds& DeedsOf(Name function) {
    const auto [known, is_new] = deeds_.try_emplace(function.index);
    const auto found = is_new ? functions_.find(function.index) : functions_.end();
    if (found == functions_.end()) return known->second;
    for (const ast::FunctionDecl* decl : found->second) {
      for (const ast::DeclId parameter : context_[decl->parameters])
        Collect(context_.Get<ast::VarDecl>(parameter).init, known->second);
      ForEachExprIn(context_, decl->body, [&](ast::ExprId id) { Collect(id, known->second); });
    }
    return known->second;
  }

  void Collect(ast::ExprId id, Deeds& deeds) const {
    if (!id) return;
    ast::ForEachChild(context_[id].node, Overloaded{
                                             [&](ast::ExprId child) { Collect(child, deeds); },
                                             [&](List<ast::ExprId> children) {
                                               for (const ast::ExprId child : context_[children])
                                                 Collect(child, deeds);
                                             },
                                             [](ast::TypeId) {},
                                         });
    if (MayCallOperator(context_, id)) {
      for (const auto& [text, name] : context_.functions.operators) deeds.called.push_back(name);
    }
    Visit(Overloaded{
              [&](const ast::UnaryExpr& e) {
                if (e.op && ChangesOperand(*e.op)) Change(e.operand, deeds);
              },
              [&](const ast::AssignExpr& e) { Change(e.left, deeds); },
              [&](const ast::CallExpr& e) { CollectCall(e, deeds); },
              [](const auto&) {},
          },
          context_[id].node);
  }

  void CollectCall(const ast::CallExpr& call, Deeds& deeds) const {
    const auto* name = context_.GetIf<ast::NameExpr>(call.callee);
    const auto* member = context_.GetIf<ast::MemberExpr>(call.callee);
    if (!name && !member) return;
    const Name callee = name ? name->name.name : member->name;
    deeds.called.push_back(callee);
    if (member) Change(member->base, deeds);  // buffer.Store(..)
    const auto arguments = context_[call.arguments];
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (MayWrite(callee, i)) Change(arguments[i], deeds);
    }
  }

  // Whether a function of the name may write its argument number `i`.
  bool MayWrite(Name function, std::size_t i) const {
    const auto found = functions_.find(function.index);
    if (found == functions_.end()) return IsWritingIntrinsic(context_[function]);
    return std::ranges::any_of(found->second, [&](const ast::FunctionDecl* decl) {
      const auto parameters = context_[decl->parameters];
      const auto* var =
          i < parameters.size() ? context_.GetIf<ast::VarDecl>(parameters[i]) : nullptr;
      return var && (var->qualifiers & ast::kOut) != 0;
    });
  }

  // Notes that the path is changed.
  void Change(ast::ExprId path, Deeds& deeds) const {
    while (path) {
      const auto* member = context_.GetIf<ast::MemberExpr>(path);
      const auto* index = context_.GetIf<ast::IndexExpr>(path);
      if (const auto* name = context_.GetIf<ast::NameExpr>(path))
        deeds.changed.push_back(name->name.name);
      if (member && context_.Is<ast::TypeExpr>(member->base))  // S<int>::x
        deeds.changed.push_back(member->name);
      path = member ? member->base : index ? index->base : ast::ExprId{};
    }
  }

  const Context& context_;
  std::vector<bool> is_kept_;                                                           // by Name
  std::unordered_map<std::uint32_t, std::vector<const ast::FunctionDecl*>> functions_;  // by Name
  std::unordered_map<std::uint32_t, Deeds> deeds_;                                      // likewise
};

// Whether the text of an expression has anything in it that may have an effect.
bool CallsOrAssigns(const Context& context, ast::ExprId id) {
  if (!id) return false;
  if (MayCallOperator(context, id)) return true;
  const auto* call = context.GetIf<ast::CallExpr>(id);
  const auto* unary = context.GetIf<ast::UnaryExpr>(id);
  const auto* name = call ? context.GetIf<ast::NameExpr>(call->callee) : nullptr;
  if (name &&
      (!IsIntrinsicName(context[name->name.name]) || IsWritingIntrinsic(context[name->name.name])))
    return true;
  if (call && context.Is<ast::MemberExpr>(call->callee)) return true;
  if (context.Is<ast::AssignExpr>(id) || (unary && unary->op && ChangesOperand(*unary->op)))
    return true;
  bool found = false;
  const auto search = [&](ast::ExprId child) { found = found || CallsOrAssigns(context, child); };
  ast::ForEachChild(context[id].node, Overloaded{
                                          search,
                                          [&](List<ast::ExprId> children) {
                                            std::ranges::for_each(context[children], search);
                                          },
                                          [](ast::TypeId) {},
                                      });
  return found;
}

// The static variables outside of functions that nothing has named and whose initial values may
// have effects.
std::vector<SymbolId> UnnamedStatics(Context& context) {
  std::vector<SymbolId> list;
  for (const SymbolId id : context.names.symbol_ids()) {
    const Symbol& symbol = context[id];
    if (symbol.kind != SymbolKind::kVariable || symbol.resolution != Resolution::kNone ||
        !symbol.scope || !symbol.decl)
      continue;
    const auto* var = context.GetIf<ast::VarDecl>(symbol.decl);
    if (var && (var->qualifiers & ast::kStatic) &&
        CallsOrAssigns(context, InitOf(context, id, *var)))
      list.push_back(id);
  }
  return list;
}

// Leaves out those of the variables that nothing names and that have no effect after all.
void LeaveOutIdle(Context& context, std::span<const VarId> added) {
  const Program& program = context.program;
  std::vector<bool> is_named(program.vars.size());
  for (const ExprId id : program.exprs.ids()) {
    if (const auto* ref = As<VarRef>(program, id)) is_named[ref->var.index] = true;
  }
  Effects effects(program);
  std::erase_if(context.globals.reached, [&](const Globals::Ordered& global) {
    const bool is_added = std::ranges::find(added, global.var) != added.end();
    const ExprId init = context[global.var].init;
    return is_added && !is_named[global.var.index] && init && effects.MayBeSkipped(init);
  });
}

}  // namespace

void ReachStaticEffects(Context& context) {
  std::vector<SymbolId> unnamed = UnnamedStatics(context);
  if (unnamed.empty()) return;
  EffectSearch search(context);
  std::vector<VarId> added;
  const auto reach = [&](SymbolId id) {
    if (context[id].resolution != Resolution::kNone) return true;
    const auto& var = context.Get<ast::VarDecl>(context[id].decl);
    if (!search.HasEffect(InitOf(context, id, var))) return false;
    if (ResolveVar(context, id)) added.push_back(VarId{context[id].value});
    return true;
  };
  // What the initial values that are reached read, others may change.
  for (bool is_done = false; !is_done && !context.diagnostics.has_errors();) {
    search.NoteReached();
    is_done = std::erase_if(unnamed, reach) == 0;
    CheckBodies(context);
  }
  if (context.diagnostics.has_errors()) return;
  LeaveOutIdle(context, added);
}

}  // namespace clipc::check
