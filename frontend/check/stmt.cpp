// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/stmt.h"

#include "base/overloaded.h"
#include "base/spelling.h"
#include "frontend/check/assign.h"
#include "frontend/check/bit_field.h"
#include "frontend/check/declare.h"
#include "frontend/check/emit.h"
#include "frontend/check/enum_class.h"
#include "frontend/check/expr.h"
#include "frontend/check/function.h"
#include "frontend/check/global.h"
#include "frontend/check/init.h"
#include "frontend/check/loop.h"
#include "frontend/check/scope.h"
#include "frontend/check/static_local.h"
#include "frontend/check/struct.h"
#include "frontend/check/switch.h"
#include "frontend/check/type.h"
#include "frontend/check/unroll.h"
#include "frontend/check/value.h"
#include "ir/access.h"

namespace clipc::check {
namespace {

// The word of a statement that nothing after it in its block is reached from; empty for others.
std::string_view JumpOf(const Context& context, ast::StmtId stmt) {
  if (context.Is<ast::ReturnStmt>(stmt)) return "return";
  if (context.Is<ast::BreakStmt>(stmt)) return "break";
  return context.Is<ast::ContinueStmt>(stmt) ? "continue" : "";
}

void CheckLocal(Context& context, ast::DeclId id, const ast::VarDecl& var) {
  if (var.semantic.name)
    context.Report(var.semantic.span, diag::SemanticOnLocal, context[var.name],
                   context[var.semantic.name]);
  if (var.qualifiers & ast::kStatic) return CheckStaticLocal(context, id, var);
  TypeId type = ResolveVarType(context, var);
  ExprId init;
  if (var.init && IsInterface(context, type)) {
    // Direct3D's interface stands for an instance. The variable gets the class of the instance,
    // which is then known.
    init = CheckExpr(context, var.init);
    const TypeId given = context.TypeIdOf(init);
    if (DerivesFrom(context, given, type)) type = given;
    if (!context.IsError(init)) init = Implicit(context, init, type);
  } else if (var.init && !context.IsError(type)) {
    init = CheckInit(context, var.init, type);
    // DXC's patches are objects of their own.
    if (context.program.profile.IsAtLeast(6, 0) && !context.IsError(init) && IsPatch(context, var))
      init = context.Fail(context[var.init].span, diag::CannotConvert, context.TypeName(init),
                          context[context[var.type].name.name]);
    if (var.dimensions.empty()) CheckEnumClass(context, var.type, init);
  }
  const SymbolId symbol = DeclareLocal(context, SymbolKind::kVariable, var.name, id, var.name_span);
  context[symbol].resolution = Resolution::kDone;
  NoteType(context, symbol, var);
  if (context.IsError(type)) return;
  if (init && context.IsError(init)) init = {};
  const ast::Qualifiers qualifiers = QualifiersOf(context, var);
  const VarId result = AddVar(context, var.name, type, Storage::kLocal, var.name_span);
  Var& local = context[result];
  local.precise = (qualifiers & ast::kPrecise) != 0;
  local.row_major = IsRowMajor(context, qualifiers);
  context[symbol].value = result.index;
  if (qualifiers & ast::kConst) {
    MarkConst(context, result);
    if (!var.init) context.Report(var.name_span, diag::ConstWithoutValue, context[var.name]);
    // Only arrays' sizes and case labels look through the variable, so scalars are enough.
    if (init && IsConstantExpr(context, init) && context[type].kind == TypeKind::kScalar) {
      local.storage = Storage::kConstant;
      local.init = Clone(context.program, init);
    }
  }
  // The first bit-field that is written would read the number that it is a part of.
  if (!init && HoldsBits(context, type)) init = context.At(var.name_span).ZeroOf(type);
  if (init) init = Unwrap(context, init);
  if (type != context.types.String()) Emit(context, var.name_span, Declare{result, init});
}

void CheckNode(Context& context, const ast::DeclStmt& stmt, Span) {
  for (ast::DeclId id : context[stmt.decls]) {
    const ast::Decl& decl = context[id];
    if (const auto* var = std::get_if<ast::VarDecl>(&decl.node)) {
      CheckLocal(context, id, *var);
    } else if (const auto* use = std::get_if<ast::UsingDecl>(&decl.node)) {
      DeclareUsing(context, *use, decl.span, context.view.scope);
    } else if (const auto* function = std::get_if<ast::FunctionDecl>(&decl.node)) {
      DeclarePrototype(context, *function);
    } else {
      DeclareLocalType(context, id);
    }
  }
}

void CheckNode(Context& context, const ast::IfStmt& stmt, Span span) {
  const ExprId condition = Unwrap(context, CheckCondition(context, stmt.condition, "if"));
  DeclareTemporaries(context);
  const StmtId then = CheckBlock(context, stmt.then);
  StmtId otherwise;
  if (stmt.otherwise) {
    // `else if` keeps its shape when nothing has to be declared before the second `if`.
    const std::size_t mark = context.stmts.size();
    if (context.Is<ast::IfStmt>(stmt.otherwise)) {
      CheckStmt(context, stmt.otherwise);
      const List<StmtId> checked = TakeStmts(context, mark);
      otherwise = checked.size == 1 ? context[checked].front()
                                    : context.At(context[stmt.otherwise].span).Stmt(Block{checked});
    } else {
      otherwise = CheckBlock(context, stmt.otherwise);
    }
  }
  Emit(context, span, If{condition, then, otherwise});
}

void CheckNode(Context& context, const ast::ReturnStmt& stmt, Span span) {
  const TypeId wanted = context.view.body->return_type;
  const std::string_view function = context[context.view.body->function].name;
  if (!stmt.value) {
    if (wanted != context.types.Void() && !context.IsError(wanted)) {
      context.Report(span, diag::ReturnWithoutValue, function, context.TypeName(wanted));
    }
    return Emit(context, span, Return{});
  }
  if (wanted == context.types.Void()) {
    const ExprId value = CheckExpr(context, stmt.value);
    if (context.IsError(value)) return;
    if (context.TypeIdOf(value) != wanted) {
      context.Report(context[stmt.value].span, diag::ReturnFromVoid, function);
      return;
    }
    EmitValue(context, value);
    return Emit(context, span, Return{});
  }
  const ExprId returned = CheckInit(context, stmt.value, wanted);
  CheckEnumClass(context, context.view.body->written_return_type, returned);
  const ExprId value = Unwrap(context, returned);
  if (!context.IsError(value)) Emit(context, span, Return{value});
}

void CheckNode(Context& context, const ast::BlockStmt& stmt, Span) {
  CheckStmts(context, stmt.body);
}

void CheckNode(Context& context, const ast::ExprStmt& stmt, Span) {
  context.drops_value = context.Is<ast::AssignExpr>(stmt.expr);
  const ExprId value = CheckExpr(context, stmt.expr);
  if (context.IsError(value)) return;
  // The name of a texture alone does nothing, and is not a value in GLSL.
  const bool is_object = context.TypeOf(value).kind == TypeKind::kObject;
  if (is_object && ir::IsPure(context.program, value)) return;
  EmitValue(context, value);
}

void CheckNode(Context& context, const ast::BreakStmt&, Span span) {
  if (context.view.body->loops + context.view.body->switches == 0)
    context.Report(span, diag::BreakOutsideLoop);
  else
    Emit(context, span, Break{});
}

void CheckNode(Context& context, const ast::ContinueStmt&, Span span) {
  const Body& body = *context.view.body;
  if (body.loops == 0)
    context.Report(span, diag::ContinueOutsideLoop);
  else if (body.is_in_switch && !context.program.profile.IsAtLeast(6, 0))
    context.Report(span, diag::ContinueInSwitch);
  else
    Emit(context, span, Continue{});
}

void CheckNode(Context& context, const ast::CaseStmt&, Span span) {
  context.Report(span, diag::CaseOutsideSwitch);
}

void CheckNode(Context& context, const ast::DiscardStmt&, Span span) {
  const StageInfo& stage = InfoOf(context.program.stage);
  if (stage.draws_pixels)
    Emit(context, span, Discard{});
  else
    context.Report(span, diag::DiscardInVertexShader, stage.name);
}

void CheckNode(Context&, const ast::EmptyStmt&, Span) {}
void CheckNode(Context&, const ast::ErrorStmt&, Span) {}

bool IsLoop(const ast::Stmt& stmt) {
  return std::holds_alternative<ast::ForStmt>(stmt.node) ||
         std::holds_alternative<ast::WhileStmt>(stmt.node) ||
         std::holds_alternative<ast::DoStmt>(stmt.node);
}

// The hint that the attributes of a statement give; the last of several counts. An attribute at a
// kind of statement that is not its own gives no hint.
Hint HintOf(const Context& context, const ast::Stmt& stmt) {
  const bool is_loop = IsLoop(stmt);
  const bool is_choice = std::holds_alternative<ast::IfStmt>(stmt.node) ||
                         std::holds_alternative<ast::SwitchStmt>(stmt.node);
  Hint hint = Hint::kNone;
  for (const ast::Attr& attribute : context[stmt.attributes]) {
    const std::string_view name = context[attribute.name];
    if (is_loop && EqualIgnoringCase(name, "unroll")) hint = Hint::kUnroll;
    if (is_loop && EqualIgnoringCase(name, "loop")) hint = Hint::kLoop;
    if (is_choice && EqualIgnoringCase(name, "branch")) hint = Hint::kBranch;
    if (is_choice && EqualIgnoringCase(name, "flatten")) hint = Hint::kFlatten;
  }
  return hint;
}

}  // namespace

void CheckStmts(Context& context, List<ast::StmtId> stmts) {
  std::string_view jump;
  for (const ast::StmtId stmt : context[stmts]) {
    if (!jump.empty() && !context.Is<ast::EmptyStmt>(stmt))
      context.Report(context[stmt].span, diag::UnreachableCode, jump);
    CheckStmt(context, stmt);
    jump = JumpOf(context, stmt);
  }
}

StmtId CheckBlock(Context& context, ast::StmtId id) {
  const std::size_t mark = context.stmts.size();
  const ScopeTable::LocalScope scope(context.names);
  if (const auto* block = context.GetIf<ast::BlockStmt>(id))
    CheckStmts(context, block->body);
  else
    CheckStmt(context, id);
  return context.At(context[id].span).Stmt(Block{TakeStmts(context, mark)});
}

void CheckStmt(Context& context, ast::StmtId id) {
  const ast::Stmt& stmt = context[id];
  const Span span = stmt.span;
  const RecursionGuard guard(context, span);
  if (!guard.ok() || context.diagnostics.TooManyErrors()) return;
  if (context.Is<ast::BlockStmt>(id)) return context.stmts.push_back(CheckBlock(context, id));
  const std::size_t mark = context.stmts.size();
  Visit([&](const auto& node) { CheckNode(context, node, span); }, stmt.node);
  if (context.stmts.size() == mark) return;
  const Hint hint = HintOf(context, stmt);
  if (IsLoop(stmt)) CheckIterations(context, context.stmts.back(), span, hint);
  if (stmt.attributes.empty()) return;
  context.program.stmts[context.stmts.back()].hint = hint;
  if (hint != Hint::kUnroll) return;
  for (const ast::Attr& attribute : context[stmt.attributes]) {
    if (attribute.arguments.size == 1 && EqualIgnoringCase(context[attribute.name], "unroll"))
      LimitIterations(context, attribute);
  }
}

ExprId CheckScalar(Context& context, ast::ExprId id, std::string_view statement) {
  const ExprId value = CheckExpr(context, id);
  if (context.IsError(value)) return value;
  const Type& type = context.TypeOf(value);
  if (type.IsNumeric() && type.Components() == 1) return value;
  return context.Fail(context[id].span, diag::ConditionNotScalar, statement,
                      context.TypeName(value));
}

ExprId CheckCondition(Context& context, ast::ExprId id, std::string_view statement) {
  // dxc's -Wparentheses; fxc has no word about it. Parentheses widen the span of an expression.
  const auto* assign = context.GetIf<ast::AssignExpr>(id);
  const bool has_parens = assign && context[id].span.begin != context[assign->left].span.begin;
  if (assign && !assign->op && !has_parens && context.program.profile.IsAtLeast(6, 0))
    context.Report(context[id].span, diag::AssignmentAsCondition, statement);
  const ExprId value = CheckScalar(context, id, statement);
  return context.IsError(value)
             ? value
             : ConvertSilently(context, value, context.types.Make(Scalar::kBool));
}

}  // namespace clipc::check
