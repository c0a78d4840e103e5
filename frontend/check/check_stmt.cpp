// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "base/overloaded.h"
#include "frontend/check/checker.h"

// Statements but for loops and switch. What is checked is put at the end of stmts_.
namespace clipc {

void Checker::Emit(Span span, decltype(ir::Stmt::node) node) {
  DeclareTemporaries();
  stmts_.push_back(At(span).Stmt(std::move(node)));
}

// The temporaries that the expressions checked last need are declared before the statement they
// belong to.
void Checker::DeclareTemporaries() {
  for (ir::VarId var : context_.body->temporaries) {
    stmts_.push_back(At(program_.vars[var].span).Stmt(ir::Declare{var, {}}));
  }
  context_.body->temporaries.clear();
}

// An expression for what it does. The steps of a Comma are statements of their own, and the
// assignment that makes a temporary is its declaration.
void Checker::EmitValue(ir::ExprId value) {
  const ir::Expr& expr = program_.exprs[value];
  const Span span = expr.span;
  if (const auto* comma = std::get_if<ir::Comma>(&expr.node)) {
    const ir::ExprId second = comma->second;
    EmitValue(comma->first);
    if (!std::holds_alternative<ir::VarRef>(program_.exprs[second].node)) EmitValue(second);
    return;
  }
  const auto* assign = std::get_if<ir::Assign>(&expr.node);
  if (!assign) return Emit(span, ir::Evaluate{value});
  const ir::ExprId target = assign->target;
  const auto* ref = std::get_if<ir::VarRef>(&program_.exprs[target].node);
  std::vector<ir::VarId>& temporaries = context_.body->temporaries;
  const auto found = ref ? std::ranges::find(temporaries, ref->var) : temporaries.end();
  if (found != temporaries.end()) {
    const ir::VarId var = *found;
    const ir::ExprId init = Unwrap(assign->value);
    // The value may use temporaries that were made before this one.
    const std::vector<ir::VarId> later = TakeBehind(var);
    DeclareTemporaries();
    temporaries = later;
    stmts_.push_back(At(span).Stmt(ir::Declare{var, init}));
    return;
  }
  // The target is evaluated first; a path without side effects does not care.
  if (ir::IsPure(program_, target)) {
    const ir::ExprId inner = Unwrap(assign->value);
    std::get<ir::Assign>(program_.exprs[value].node).value = inner;
  }
  Emit(span, ir::Evaluate{value});
}

// Takes `var` and the temporaries made after it off the list; gives the latter.
std::vector<ir::VarId> Checker::TakeBehind(ir::VarId var) {
  std::vector<ir::VarId>& temporaries = context_.body->temporaries;
  const auto found = std::ranges::find(temporaries, var);
  if (found == temporaries.end()) return {};
  std::vector<ir::VarId> later(found + 1, temporaries.end());
  temporaries.erase(found, temporaries.end());
  return later;
}

// Makes statements of the steps before a value that is evaluated once, first thing in its
// statement.
ir::ExprId Checker::Unwrap(ir::ExprId value) {
  while (const auto* comma = std::get_if<ir::Comma>(&program_.exprs[value].node)) {
    const ir::ExprId second = comma->second;
    EmitValue(comma->first);
    value = second;
  }
  return value;
}

void Checker::CheckStmts(List<ast::StmtId> stmts) {
  for (std::uint32_t i = 0; i < stmts.size; ++i) CheckStmt(file_.stmt_lists[stmts][i]);
}

// A statement that is the body of another, always a Block, with a scope of its own.
ir::StmtId Checker::CheckBlock(ast::StmtId id) {
  const ast::Stmt& stmt = file_.stmts[id];
  const std::size_t mark = stmts_.size();
  const LocalScope scope(*this);
  if (const auto* block = std::get_if<ast::BlockStmt>(&stmt.node)) {
    CheckStmts(block->body);
  } else {
    CheckStmt(id);
  }
  const ir::StmtId result =
      At(stmt.span).BlockOf(std::span<const ir::StmtId>(stmts_).subspan(mark));
  stmts_.resize(mark);
  return result;
}

void Checker::CheckStmt(ast::StmtId id) {
  const ast::Stmt& stmt = file_.stmts[id];
  const Span span = stmt.span;
  const Depth depth(*this, span);
  if (!depth.ok() || diagnostics_.TooManyErrors()) return;
  Body& body = *context_.body;
  Visit(
      Overloaded{
          [&](const ast::BlockStmt&) { stmts_.push_back(CheckBlock(id)); },
          [&](const ast::DeclStmt& s) { CheckDeclStmt(s); },
          [&](const ast::ExprStmt& s) {
            const ir::ExprId value = CheckExpr(s.expr);
            if (!IsError(value)) EmitValue(value);
          },
          [&](const ast::IfStmt& s) { CheckIf(s, span); },
          [&](const ast::ForStmt& s) { CheckFor(s, span); },
          [&](const ast::WhileStmt& s) { CheckWhile(s, span); },
          [&](const ast::DoStmt& s) { CheckDo(s, span); },
          [&](const ast::SwitchStmt& s) { CheckSwitch(s, span); },
          [&](const ast::CaseStmt&) { diagnostics_.Report(span, diag::CaseOutsideSwitch); },
          [&](const ast::ReturnStmt& s) { CheckReturn(s, span); },
          [&](const ast::BreakStmt&) {
            if (body.loops + body.switches == 0)
              diagnostics_.Report(span, diag::BreakOutsideLoop);
            else
              Emit(span, ir::Break{});
          },
          [&](const ast::ContinueStmt&) {
            if (body.loops == 0)
              diagnostics_.Report(span, diag::ContinueOutsideLoop);
            else
              Emit(span, ir::Continue{});
          },
          [&](const ast::DiscardStmt&) { diagnostics_.Report(span, diag::DiscardInVertexShader); },
          [](const ast::EmptyStmt&) {},
          [](const ast::ErrorStmt&) {},
      },
      stmt.node);
}

void Checker::CheckDeclStmt(const ast::DeclStmt& stmt) {
  for (std::uint32_t i = 0; i < stmt.decls.size; ++i) {
    const ast::DeclId id = file_.decl_lists[stmt.decls][i];
    const ast::Decl& decl = file_.decls[id];
    if (const auto* var = std::get_if<ast::VarDecl>(&decl.node)) {
      CheckLocal(id, *var);
    } else if (const auto* use = std::get_if<ast::UsingDecl>(&decl.node)) {
      DeclareUsing(*use, decl.span, context_.scope);
    } else {
      DeclareLocalType(id);
    }
  }
}

void Checker::CheckLocal(ast::DeclId id, const ast::VarDecl& var) {
  if (var.qualifiers & ast::kStatic) return CheckStaticLocal(id, var);
  if (var.qualifiers & (ast::kGroupShared | ast::kUniform)) {
    diagnostics_.Report(var.name_span, diag::LocalStorage, Text(var.name),
                        var.qualifiers & ast::kUniform ? "uniform" : "groupshared");
  }
  const ir::TypeId type = ResolveVarType(var);
  ir::ExprId init;
  if (var.init && type != program_.types.Error()) init = CheckInit(var.init, type);
  const SymbolId symbol = DeclareLocal(SymbolKind::kVariable, var.name, id, var.name_span);
  symbols_[symbol].resolution = Resolution::kDone;
  if (type == program_.types.Error()) return;
  if (init && IsError(init)) init = {};
  const ast::Qualifiers qualifiers = QualifiersOf(var);
  const ir::VarId result = AddVar(var.name, type, ir::Storage::kLocal, var.name_span);
  ir::Var& local = program_.vars[result];
  local.precise = (qualifiers & ast::kPrecise) != 0;
  local.row_major = IsRowMajor(qualifiers);
  symbols_[symbol].value = result.index;
  if (qualifiers & ast::kConst) {
    MarkConst(result);
    if (!var.init) diagnostics_.Report(var.name_span, diag::ConstWithoutValue, Text(var.name));
    // Only arrays' sizes and case labels look through the variable, so scalars are enough.
    if (init && IsConstantExpr(init) && program_.types[type].kind == ir::TypeKind::kScalar) {
      local.storage = ir::Storage::kConstant;
      local.init = ir::Clone(program_, init);
    }
  }
  if (init) init = Unwrap(init);
  Emit(var.name_span, ir::Declare{result, init});
}

// A global that only this function can name.
void Checker::CheckStaticLocal(ast::DeclId id, const ast::VarDecl& var) {
  const SymbolId symbol = DeclareLocal(SymbolKind::kVariable, var.name, id, var.name_span);
  symbols_[symbol].resolution = Resolution::kDone;
  Context context = context_;
  context.body = nullptr;
  const ContextSwitch in(*this, context);
  ResolveStatic(symbol, var);
}

ir::ExprId Checker::CheckCondition(ast::ExprId id, std::string_view statement) {
  const ir::ExprId value = CheckExpr(id);
  if (IsError(value)) return value;
  const ir::Type& type = TypeOf(value);
  if (!type.IsNumeric() || type.Components() != 1) {
    diagnostics_.Report(file_.exprs[id].span, diag::ConditionNotScalar, statement,
                        TypeName(TypeIdOf(value)));
    return ErrorExpr(file_.exprs[id].span);
  }
  return ConvertSilently(value, program_.types.Make(ir::Scalar::kBool));
}

void Checker::CheckIf(const ast::IfStmt& stmt, Span span) {
  const ir::ExprId condition = Unwrap(CheckCondition(stmt.condition, "if"));
  DeclareTemporaries();
  const ir::StmtId then = CheckBlock(stmt.then);
  ir::StmtId otherwise;
  if (stmt.otherwise) {
    // `else if` keeps its shape when nothing has to be declared before the second `if`.
    const std::size_t mark = stmts_.size();
    if (std::holds_alternative<ast::IfStmt>(file_.stmts[stmt.otherwise].node)) {
      CheckStmt(stmt.otherwise);
      const bool is_one = stmts_.size() == mark + 1;
      otherwise = is_one ? stmts_.back()
                         : At(file_.stmts[stmt.otherwise].span)
                               .BlockOf(std::span<const ir::StmtId>(stmts_).subspan(mark));
      stmts_.resize(mark);
    } else {
      otherwise = CheckBlock(stmt.otherwise);
    }
  }
  Emit(span, ir::If{condition, then, otherwise});
}

void Checker::CheckReturn(const ast::ReturnStmt& stmt, Span span) {
  const ir::TypeId wanted = context_.body->return_type;
  const std::string_view function = program_.functions[context_.body->function].name;
  if (!stmt.value) {
    if (wanted != program_.types.Void() && wanted != program_.types.Error()) {
      diagnostics_.Report(span, diag::ReturnWithoutValue, function, TypeName(wanted));
    }
    return Emit(span, ir::Return{});
  }
  if (wanted == program_.types.Void()) {
    const ir::ExprId value = CheckExpr(stmt.value);
    if (IsError(value)) return;
    if (TypeIdOf(value) != wanted) {
      diagnostics_.Report(file_.exprs[stmt.value].span, diag::ReturnFromVoid, function);
      return;
    }
    EmitValue(value);
    return Emit(span, ir::Return{});
  }
  const ir::ExprId value = Unwrap(CheckInit(stmt.value, wanted));
  if (!IsError(value)) Emit(span, ir::Return{value});
}

// Whether control can reach what follows the statement.
bool Checker::FallsThrough(ir::StmtId id) const {
  const auto always = [&](ir::ExprId condition) {
    if (!condition) return true;
    const auto* literal = std::get_if<ir::Literal>(&program_.exprs[condition].node);
    return literal && literal->bits != 0;
  };
  return Visit(Overloaded{
                   [&](const ir::Block& s) {
                     return std::ranges::all_of(program_.stmt_lists[s.body], [&](ir::StmtId stmt) {
                       return FallsThrough(stmt);
                     });
                   },
                   [&](const ir::If& s) {
                     return !s.otherwise || FallsThrough(s.then) || FallsThrough(s.otherwise);
                   },
                   [&](const ir::For& s) { return !always(s.condition) || Breaks(s.body); },
                   [&](const ir::While& s) { return !always(s.condition) || Breaks(s.body); },
                   [&](const ir::DoWhile& s) {
                     return (!always(s.condition) && FallsThrough(s.body)) || Breaks(s.body);
                   },
                   [&](const ir::Switch& s) {
                     bool falls = true, has_default = false, breaks = false;
                     for (const ir::SwitchCase& arm : program_.switch_cases[s.cases]) {
                       falls = true;
                       has_default = has_default || arm.is_default;
                       for (ir::StmtId stmt : program_.stmt_lists[arm.body]) {
                         falls = falls && FallsThrough(stmt);
                         breaks = breaks || Breaks(stmt);
                       }
                     }
                     return falls || !has_default || breaks;
                   },
                   [](const ir::Return&) { return false; },
                   [](const ir::Break&) { return false; },
                   [](const ir::Continue&) { return false; },
                   [](const auto&) { return true; },
               },
               program_.stmts[id].node);
}

// Whether a `break` in it leaves the loop or switch whose body it is (a `continue` of a do-while
// may leave it, too).
bool Checker::Breaks(ir::StmtId id) const {
  if (!id) return false;
  return Visit(Overloaded{
                   [&](const ir::Block& s) {
                     return std::ranges::any_of(program_.stmt_lists[s.body],
                                                [&](ir::StmtId stmt) { return Breaks(stmt); });
                   },
                   [&](const ir::If& s) { return Breaks(s.then) || Breaks(s.otherwise); },
                   [](const ir::Break&) { return true; },
                   [](const auto&) { return false; },
               },
               program_.stmts[id].node);
}

}  // namespace clipc
