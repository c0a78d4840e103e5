// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/check/checker.h"
#include "frontend/rules/constant.h"

// Loops and switch.
namespace clipc {

void Checker::CheckFor(const ast::ForStmt& stmt, Span span) {
  struct Kept {
    Name name;
    SymbolId symbol;
  };
  std::vector<Kept> variables;
  ir::For loop;
  {
    const LocalScope scope(*this);
    const std::size_t mark = locals_.size();
    if (stmt.init) CheckForInit(stmt.init, loop);
    for (std::size_t i = mark; i < locals_.size(); ++i)
      variables.push_back({symbols_[locals_[i]].name, locals_[i]});
    if (stmt.condition) loop.condition = CheckCondition(stmt.condition, "for");
    if (stmt.step) loop.step = CheckExpr(stmt.step);
    DeclareTemporaries();
    ++context_.body->loops;
    loop.body = CheckBlock(stmt.body);
    --context_.body->loops;
  }
  Emit(span, loop);
  // fxc lets the variables live on (X3078 tells of the conflicts that makes).
  for (const Kept& kept : variables) {
    const SymbolId hidden = local_by_name_[kept.name.index];
    if (hidden && hidden.index >= context_.local_floor && !symbols_[hidden].is_leaked) continue;
    const Symbol variable = symbols_[kept.symbol];
    const SymbolId leaked =
        DeclareLocal(variable.kind, variable.name, variable.decl, variable.span);
    symbols_[leaked].is_leaked = true;
    symbols_[leaked].value = variable.value;
    symbols_[leaked].resolution = Resolution::kDone;
    symbols_[leaked].owner = stmts_.back().index;
  }
}

void Checker::CheckForInit(ast::StmtId init, ir::For& loop) {
  const std::size_t mark = stmts_.size();
  if (const auto* stmt = std::get_if<ast::ExprStmt>(&file_.stmts[init].node)) {
    const ir::ExprId value = CheckExpr(stmt->expr);
    if (IsError(value)) return;
    DeclareTemporaries();
    loop.init = program_.stmt_lists.Add({At(file_.stmts[init].span).Eval(value)});
    return;
  }
  CheckStmt(init);
  const std::span<const ir::StmtId> emitted = std::span<const ir::StmtId>(stmts_).subspan(mark);
  if (emitted.empty()) return;
  const auto type_of = [&](ir::StmtId id) {
    const auto* declare = std::get_if<ir::Declare>(&program_.stmts[id].node);
    return declare ? program_.vars[declare->var].type : ir::TypeId{};
  };
  const ir::TypeId type = type_of(emitted.front());
  const bool one_type =
      type && std::ranges::all_of(emitted, [&](ir::StmtId id) { return type_of(id) == type; });
  // Anything else stands before the loop.
  if (!one_type) return;
  const std::vector<ir::StmtId> stmts(emitted.begin(), emitted.end());
  loop.init = program_.stmt_lists.Add(std::span<const ir::StmtId>(stmts));
  stmts_.resize(mark);
}

// A variable of a finished `for` is used: it moves to the top of the function.
void Checker::HoistLoopVariable(SymbolId id) {
  Symbol& symbol = symbols_[id];
  if (symbol.owner == ~0u) return;
  auto& loop = std::get<ir::For>(program_.stmts[ir::StmtId{symbol.owner}].node);
  symbol.owner = ~0u;
  ir::ExprId assignments;
  const std::vector<ir::StmtId> init(program_.stmt_lists[loop.init].begin(),
                                     program_.stmt_lists[loop.init].end());
  for (ir::StmtId stmt : init) {
    const auto* declare = std::get_if<ir::Declare>(&program_.stmts[stmt].node);
    if (!declare) return;
    const ir::VarId var = declare->var;
    const ir::ExprId value = declare->init;
    const ir::Builder builder = At(program_.vars[var].span);
    context_.body->hoisted.push_back(ir::Builder(builder).Stmt(ir::Declare{var, {}}));
    if (!value) continue;
    ir::Builder at = At(program_.vars[var].span);
    const ir::ExprId assignment = at.AssignTo(at.Ref(var), value);
    assignments = assignments ? at.CommaOf(assignments, assignment) : assignment;
  }
  loop.init = {};
  if (assignments)
    loop.init = program_.stmt_lists.Add({At(program_.exprs[assignments].span).Eval(assignments)});
}

void Checker::CheckWhile(const ast::WhileStmt& stmt, Span span) {
  const ir::ExprId condition = CheckCondition(stmt.condition, "while");
  DeclareTemporaries();
  ++context_.body->loops;
  const ir::StmtId body = CheckBlock(stmt.body);
  --context_.body->loops;
  Emit(span, ir::While{condition, body});
}

void Checker::CheckDo(const ast::DoStmt& stmt, Span span) {
  ++context_.body->loops;
  const ir::StmtId body = CheckBlock(stmt.body);
  --context_.body->loops;
  const ir::ExprId condition = CheckCondition(stmt.condition, "while");
  Emit(span, ir::DoWhile{body, condition});
}

void Checker::CheckSwitch(const ast::SwitchStmt& stmt, Span span) {
  ir::ExprId value = CheckExpr(stmt.value);
  if (!IsError(value)) {
    const ir::Type& type = TypeOf(value);
    if (!type.IsNumeric() || type.Components() != 1) {
      diagnostics_.Report(file_.exprs[stmt.value].span, diag::ConditionNotScalar, "switch",
                          TypeName(TypeIdOf(value)));
      value = ErrorExpr(span);
    } else {
      const ir::Scalar kind = ir::IsUnsigned(type.scalar) ? ir::Scalar::kUint : ir::Scalar::kInt;
      value = ConvertSilently(value, program_.types.Make(kind));
    }
  }
  const ir::TypeId type = TypeIdOf(value);
  DeclareTemporaries();
  const auto* block = std::get_if<ast::BlockStmt>(&file_.stmts[stmt.body].node);
  if (!block) {
    diagnostics_.Report(span, diag::SwitchWithoutBlock);
    return;
  }
  ++context_.body->switches;
  const LocalScope scope(*this);
  std::vector<ir::SwitchCase> arms;
  std::vector<ir::ExprId> labels;
  std::unordered_set<std::int64_t> seen;
  const std::size_t mark = stmts_.size();
  const auto finish = [&] {
    if (!arms.empty()) {
      const std::vector<ir::StmtId> body(stmts_.begin() + static_cast<std::ptrdiff_t>(mark),
                                         stmts_.end());
      arms.back().body = program_.stmt_lists.Add(std::span<const ir::StmtId>(body));
      arms.back().labels = program_.expr_lists.Add(std::span<const ir::ExprId>(labels));
    }
    labels.clear();
    stmts_.resize(mark);
  };
  bool reported = false;
  for (std::uint32_t i = 0; i < block->body.size; ++i) {
    const ast::StmtId inner = file_.stmt_lists[block->body][i];
    const ast::Stmt& child = file_.stmts[inner];
    if (const auto* label = std::get_if<ast::CaseStmt>(&child.node)) {
      if (arms.empty() || stmts_.size() > mark) {
        finish();
        arms.emplace_back();
      }
      if (const auto value = CheckCaseLabel(*label, child.span, seen)) {
        labels.push_back(At(child.span).Add(type, ir::Literal{static_cast<std::uint32_t>(*value)}));
      } else {
        arms.back().is_default = arms.back().is_default || !label->value;
      }
      continue;
    }
    if (arms.empty() && !reported) diagnostics_.Report(child.span, diag::StatementBeforeCase);
    reported = reported || arms.empty();
    CheckStmt(inner);
  }
  finish();
  --context_.body->switches;
  Emit(span, ir::Switch{value, program_.switch_cases.Add(std::span<const ir::SwitchCase>(arms))});
}

// The value of a label; nothing for `default`, and after an error, which was reported.
std::optional<std::int64_t> Checker::CheckCaseLabel(const ast::CaseStmt& stmt, Span span,
                                                    std::unordered_set<std::int64_t>& seen) {
  constexpr std::int64_t kDefault = std::int64_t{1} << 40;  // no label has this value
  std::optional<std::int64_t> value = kDefault;
  if (stmt.value) value = ConstantInteger(stmt.value);
  if (!value) return std::nullopt;
  if (!seen.insert(*value).second) {
    diagnostics_.Report(span, diag::CaseTwice,
                        stmt.value ? fmt::format("case {}", *value) : "default");
    return std::nullopt;
  }
  return stmt.value ? value : std::nullopt;
}

}  // namespace clipc
