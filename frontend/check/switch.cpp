// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/switch.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

#include "frontend/check/emit.h"
#include "frontend/check/flow.h"
#include "frontend/check/large_literal.h"
#include "frontend/check/stmt.h"
#include "frontend/check/value.h"

namespace clipc::check {
namespace {

// The labels of a switch that were seen; `default` is none.
using SeenLabels = std::unordered_map<std::optional<std::int64_t>, Span>;

// The value of a label, one that the type may have; nullopt for `default`, and after an error,
// which was reported.
std::optional<std::int64_t> CheckCaseLabel(Context& context, const ast::CaseStmt& stmt, Span span,
                                           Scalar kind, SeenLabels& seen) {
  std::optional<std::int64_t> value;
  if (stmt.value) value = ConstantInteger(context, stmt.value);
  if (stmt.value && !value) return std::nullopt;
  if (value && !IsWide(kind)) value = TruncatedTo(context, *value, kind, context[stmt.value].span);
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

// The value that a switch chooses by.
struct Chooser {
  ExprId value;
  bool is_wide = false;  // an integer of 64 bits, which can be repeated
  Exprs prologue = {};
};

Chooser CheckChooser(Context& context, ast::ExprId written) {
  const Profile& profile = context.program.profile;
  ExprId value = CheckScalar(context, written, "switch");
  // fxc takes a float from 4.0 to 5.1 only (vkd3d's switch.shader_test, checked against native).
  const bool takes_float = !profile.IsDirect3D9() && !profile.IsAtLeast(6, 0);
  if (IsFloat(context.TypeOf(value).scalar) && !context.IsError(value) && !takes_float) {
    value = context.Fail(context[written].span, diag::SwitchNotInteger, context.TypeName(value));
  }
  if (context.IsError(value)) return {value};
  const Scalar kind = context.TypeOf(value).scalar;
  Chooser chooser{value, IsWide(kind) && !IsFloat(kind)};
  chooser.value =
      chooser.is_wide
          ? Repeatable(context, value, chooser.prologue)
          : ConvertSilently(context, value,
                            context.types.Make(IsUnsigned(kind) ? Scalar::kUint : Scalar::kInt));
  return chooser;
}

// The arms of a switch, whose labels have a type.
class Arms {
 public:
  Arms(Context& context, TypeId type, bool is_wide)
      : context_(context), type_(type), is_wide_(is_wide), mark_(context.stmts.size()) {}

  void Check(std::span<const ast::StmtId> children) {
    bool reported = false;
    for (const ast::StmtId inner : children) {
      const ast::Stmt& child = context_[inner];
      if (const auto* label = std::get_if<ast::CaseStmt>(&child.node)) {
        CheckLabel(*label, child.span);
        continue;
      }
      if (arms_.empty() && !reported) context_.Report(child.span, diag::StatementBeforeCase);
      reported = reported || arms_.empty();
      CheckStmt(context_, inner);
    }
    if (!children.empty() && context_.Is<ast::CaseStmt>(children.back()))
      context_.Report(context_[children.back()].span, diag::CaseWithoutStatement);
    Finish();
  }

  List<SwitchCase> Cases() const {
    return context_.program.switch_cases.Add(std::span<const SwitchCase>(arms_));
  }
  // The labels of 64 bits, which the cases have the numbers of.
  const std::vector<std::int64_t>& wide_labels() const { return wide_labels_; }

 private:
  void CheckLabel(const ast::CaseStmt& label, Span span) {
    if (arms_.empty() || context_.stmts.size() > mark_) {
      Finish();
      arms_.emplace_back();
    }
    label_span_ = span;
    const Scalar kind = is_wide_ ? Scalar::kInt64 : context_[type_].scalar;
    if (const auto value = CheckCaseLabel(context_, label, span, kind, seen_)) {
      const auto written = is_wide_ ? static_cast<std::uint32_t>(wide_labels_.size())
                                    : static_cast<std::uint32_t>(*value);
      if (is_wide_) wide_labels_.push_back(*value);
      labels_.push_back(context_.At(span).Add(type_, Literal{written}));
    } else {
      arms_.back().is_default = arms_.back().is_default || !label.value;
    }
  }
  // Gives the last arm its labels and the statements since them.
  void Finish() {
    const List<StmtId> body = TakeStmts(context_, mark_);
    if (!arms_.empty()) {
      if (!context_.program.profile.IsAtLeast(6, 0) && RunsOn(context_, body))
        context_.Report(label_span_, diag::CaseWithoutBreak);
      arms_.back().body = body;
      arms_.back().labels = context_.program.expr_lists.Add(ExprSpan(labels_));
    }
    labels_.clear();
  }

  Context& context_;
  const TypeId type_;
  const bool is_wide_;
  const std::size_t mark_;  // the statements after it are the last arm's
  std::vector<SwitchCase> arms_;
  Exprs labels_;  // of the last arm
  Span label_span_;
  SeenLabels seen_;
  std::vector<std::int64_t> wide_labels_;
};

}  // namespace

void CheckNode(Context& context, const ast::SwitchStmt& stmt, Span span) {
  Chooser chooser = CheckChooser(context, stmt.value);
  const TypeId type =
      chooser.is_wide ? context.types.Make(Scalar::kInt) : context.TypeIdOf(chooser.value);
  DeclareTemporaries(context);
  const auto* block = context.GetIf<ast::BlockStmt>(stmt.body);
  if (!block) {
    context.Report(span, diag::SwitchWithoutBlock);
    return;
  }
  ++context.view.body->switches;
  const bool was_in_switch = std::exchange(context.view.body->is_in_switch, true);
  const ScopeTable::LocalScope scope(context.names);
  Arms arms(context, type, chooser.is_wide);
  arms.Check(context[block->body]);
  context.view.body->is_in_switch = was_in_switch;
  --context.view.body->switches;
  ExprId value = chooser.value;
  if (chooser.is_wide) {
    value = WithPrologue(context, chooser.prologue,
                         NumberOfLabel(context, value, arms.wide_labels(), span));
  }
  Emit(context, span, Switch{value, arms.Cases()});
}

}  // namespace clipc::check
