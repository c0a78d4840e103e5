// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/switch.h"

#include <unordered_set>

#include "frontend/check/emit.h"
#include "frontend/check/stmt.h"
#include "frontend/check/value.h"

namespace clipc::check {
namespace {

// The value of a label; nullopt for `default`, and after an error, which was reported.
std::optional<std::int64_t> CheckCaseLabel(Context& context, const ast::CaseStmt& stmt, Span span,
                                           std::unordered_set<std::int64_t>& seen) {
  constexpr std::int64_t kDefault = std::int64_t{1} << 40;  // no label has this value
  std::optional<std::int64_t> value = kDefault;
  if (stmt.value) value = ConstantInteger(context, stmt.value);
  if (!value) return std::nullopt;
  if (!seen.insert(*value).second) {
    context.Report(span, diag::CaseTwice, stmt.value ? fmt::format("case {}", *value) : "default");
    return std::nullopt;
  }
  return stmt.value ? value : std::nullopt;
}

}  // namespace

void CheckNode(Context& context, const ast::SwitchStmt& stmt, Span span) {
  ExprId value = CheckScalar(context, stmt.value, "switch");
  if (!context.IsError(value)) {
    const bool is_unsigned = IsUnsigned(context.TypeOf(value).scalar);
    value = ConvertSilently(context, value,
                            context.types.Make(is_unsigned ? Scalar::kUint : Scalar::kInt));
  }
  const TypeId type = context.TypeIdOf(value);
  DeclareTemporaries(context);
  const auto* block = context.GetIf<ast::BlockStmt>(stmt.body);
  if (!block) {
    context.Report(span, diag::SwitchWithoutBlock);
    return;
  }
  ++context.view.body->switches;
  const ScopeTable::LocalScope scope(context.names);
  std::vector<SwitchCase> arms;
  Exprs labels;
  std::unordered_set<std::int64_t> seen;
  const std::size_t mark = context.stmts.size();
  const auto finish = [&] {
    const List<StmtId> body = TakeStmts(context, mark);
    if (!arms.empty()) {
      arms.back().body = body;
      arms.back().labels = context.program.expr_lists.Add(ExprSpan(labels));
    }
    labels.clear();
  };
  bool reported = false;
  for (ast::StmtId inner : context[block->body]) {
    const ast::Stmt& child = context[inner];
    if (const auto* label = std::get_if<ast::CaseStmt>(&child.node)) {
      if (arms.empty() || context.stmts.size() > mark) {
        finish();
        arms.emplace_back();
      }
      if (const auto value = CheckCaseLabel(context, *label, child.span, seen)) {
        labels.push_back(
            context.At(child.span).Add(type, Literal{static_cast<std::uint32_t>(*value)}));
      } else {
        arms.back().is_default = arms.back().is_default || !label->value;
      }
      continue;
    }
    if (arms.empty() && !reported) context.Report(child.span, diag::StatementBeforeCase);
    reported = reported || arms.empty();
    CheckStmt(context, inner);
  }
  finish();
  --context.view.body->switches;
  Emit(context, span,
       Switch{value, context.program.switch_cases.Add(std::span<const SwitchCase>(arms))});
}

}  // namespace clipc::check
