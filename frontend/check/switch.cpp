// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/switch.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

#include "frontend/check/emit.h"
#include "frontend/check/flow.h"
#include "frontend/check/stmt.h"
#include "frontend/check/value.h"

namespace clipc::check {
namespace {

// The labels of a switch that were seen; `default` is none.
using SeenLabels = std::unordered_map<std::optional<std::int64_t>, Span>;

// The value of a label; nullopt for `default`, and after an error, which was reported.
std::optional<std::int64_t> CheckCaseLabel(Context& context, const ast::CaseStmt& stmt, Span span,
                                           SeenLabels& seen) {
  std::optional<std::int64_t> value;
  if (stmt.value) value = ConstantInteger(context, stmt.value);
  if (stmt.value && !value) return std::nullopt;
  const auto [first, is_new] = seen.try_emplace(value, span);
  if (!is_new) {
    context.Report(span, diag::CaseTwice, stmt.value ? fmt::format("case {}", *value) : "default")
        .Note(first->second, diag::FirstGivenHere);
    return std::nullopt;
  }
  return value;
}

// The number of the label that a value of 64 bits equals, -1 where there is none, as no target has
// a switch of 64 bits: v == 5 ? 0 : v == 0x100000005 ? 1 : -1. The value is one that may be
// repeated.
ExprId NumberOfLabel(Context& context, ExprId value, const std::vector<std::int64_t>& labels,
                     Span span) {
  Builder at = context.At(span);
  ExprId number = at.Int(-1);
  for (std::size_t i = labels.size(); i-- > 0;) {
    const ExprId label =
        at.Add(context.TypeIdOf(value), Literal{static_cast<std::uint64_t>(labels[i])});
    const ExprId is_equal = at.BinaryOf(BinaryOp::kEqual, Clone(context.program, value), label);
    number = at.Add(context.types.Make(Scalar::kInt),
                    Conditional{is_equal, at.Int(static_cast<std::int32_t>(i)), number});
  }
  return number;
}

// Whether the statements of a case lead to what follows it. A label without statements does so in
// every profile.
bool RunsOn(const Context& context, List<StmtId> body) {
  return body.size != 0 && std::ranges::all_of(context[body], [&](StmtId stmt) {
           return ExitsOf(context.program, stmt).falls;
         });
}

}  // namespace

void CheckNode(Context& context, const ast::SwitchStmt& stmt, Span span) {
  const Profile& profile = context.program.profile;
  ExprId value = CheckScalar(context, stmt.value, "switch");
  // fxc takes a float from 4.0 to 5.1 only (vkd3d's switch.shader_test, checked against native).
  const bool takes_float = !profile.IsDirect3D9() && !profile.IsAtLeast(6, 0);
  if (IsFloat(context.TypeOf(value).scalar) && !context.IsError(value) && !takes_float) {
    value = context.Fail(context[stmt.value].span, diag::SwitchNotInteger, context.TypeName(value));
  }
  const bool is_wide = !context.IsError(value) && IsWide(context.TypeOf(value).scalar) &&
                       !IsFloat(context.TypeOf(value).scalar);
  Exprs prologue;
  if (is_wide) {
    value = Repeatable(context, value, prologue);
  } else if (!context.IsError(value)) {
    const bool is_unsigned = IsUnsigned(context.TypeOf(value).scalar);
    value = ConvertSilently(context, value,
                            context.types.Make(is_unsigned ? Scalar::kUint : Scalar::kInt));
  }
  const TypeId type = is_wide ? context.types.Make(Scalar::kInt) : context.TypeIdOf(value);
  std::vector<std::int64_t> wide_labels;
  DeclareTemporaries(context);
  const auto* block = context.GetIf<ast::BlockStmt>(stmt.body);
  if (!block) {
    context.Report(span, diag::SwitchWithoutBlock);
    return;
  }
  ++context.view.body->switches;
  const bool was_in_switch = std::exchange(context.view.body->is_in_switch, true);
  const ScopeTable::LocalScope scope(context.names);
  std::vector<SwitchCase> arms;
  Exprs labels;
  SeenLabels seen;
  const std::size_t mark = context.stmts.size();
  Span label_span;
  const auto finish = [&] {
    const List<StmtId> body = TakeStmts(context, mark);
    if (!arms.empty()) {
      if (!profile.IsAtLeast(6, 0) && RunsOn(context, body))
        context.Report(label_span, diag::CaseWithoutBreak);
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
      label_span = child.span;
      if (const auto value = CheckCaseLabel(context, *label, child.span, seen)) {
        const auto written = is_wide ? static_cast<std::uint32_t>(wide_labels.size())
                                     : static_cast<std::uint32_t>(*value);
        if (is_wide) wide_labels.push_back(*value);
        labels.push_back(context.At(child.span).Add(type, Literal{written}));
      } else {
        arms.back().is_default = arms.back().is_default || !label->value;
      }
      continue;
    }
    if (arms.empty() && !reported) context.Report(child.span, diag::StatementBeforeCase);
    reported = reported || arms.empty();
    CheckStmt(context, inner);
  }
  const std::span<const ast::StmtId> children = context[block->body];
  if (!children.empty() && context.Is<ast::CaseStmt>(children.back()))
    context.Report(context[children.back()].span, diag::CaseWithoutStatement);
  finish();
  context.view.body->is_in_switch = was_in_switch;
  --context.view.body->switches;
  if (is_wide) {
    value = WithPrologue(context, prologue, NumberOfLabel(context, value, wide_labels, span));
  }
  Emit(context, span,
       Switch{value, context.program.switch_cases.Add(std::span<const SwitchCase>(arms))});
}

}  // namespace clipc::check
