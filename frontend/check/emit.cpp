// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/emit.h"

#include <algorithm>

#include "frontend/check/bit_field.h"

namespace clipc::check {
namespace {

// Removes `var` and the temporaries made after it from the list. Returns the temporaries after it.
std::vector<VarId> TakeAfter(Context& context, VarId var) {
  std::vector<VarId>& temporaries = context.view.body->temporaries;
  const auto found = std::ranges::find(temporaries, var);
  if (found == temporaries.end()) return {};
  std::vector<VarId> later(found + 1, temporaries.end());
  temporaries.erase(found, temporaries.end());
  return later;
}

void EmitClip(Context& context, ExprId value, Span span) {
  Builder at = context.At(span);
  const ExprId condition = at.ClipsAt(value);
  const StmtId discard = at.Stmt(Discard{});
  Emit(context, span, If{condition, at.BlockOf({&discard, 1}), {}});
}

}  // namespace

void Emit(Context& context, Span span, decltype(Stmt::node) node) {
  DeclareTemporaries(context);
  context.stmts.push_back(context.At(span).Stmt(node));
}

List<StmtId> TakeStmts(Context& context, std::size_t mark) {
  const auto taken = std::span<const StmtId>(context.stmts).subspan(mark);
  const List<StmtId> list = context.program.stmt_lists.Add(taken);
  context.stmts.resize(mark);
  return list;
}

void DeclareTemporaries(Context& context) {
  for (VarId var : context.view.body->temporaries) {
    context.stmts.push_back(context.At(context[var].span).Stmt(Declare{var, {}}));
  }
  context.view.body->temporaries.clear();
}

ExprId WithoutString(const Context& context, ExprId value) {
  while (value && context.TypeOf(value).kind == TypeKind::kString) {
    const auto* comma = context.GetIf<Comma>(value);
    value = comma ? comma->first : ExprId{};
  }
  return value;
}

void EmitValue(Context& context, ExprId value) {
  value = WithoutString(context, value);
  if (!value) return;
  const Expr& expr = context[value];
  const Span span = expr.span;
  if (const auto* comma = std::get_if<Comma>(&expr.node)) {
    const ExprId second = comma->second;
    EmitValue(context, comma->first);
    const bool is_read = RootOf(context.program, second) || IsBitField(context, second);
    if (!is_read || !IsPure(context.program, second)) EmitValue(context, second);
    return;
  }
  const auto* call = std::get_if<IntrinsicCall>(&expr.node);
  if (call && call->op == CommonIntrinsic::kClip)
    return EmitClip(context, context.program.expr_lists[call->arguments][0], span);
  const auto* assign = std::get_if<Assign>(&expr.node);
  if (!assign) return Emit(context, span, Evaluate{value});
  const ExprId target = assign->target;
  const auto* ref = context.GetIf<VarRef>(target);
  std::vector<VarId>& temporaries = context.view.body->temporaries;
  const auto found = ref ? std::ranges::find(temporaries, ref->var) : temporaries.end();
  if (found != temporaries.end()) {
    const VarId var = *found;
    // The value may use temporaries that were made before this one, and its steps declare them.
    const std::vector<VarId> later = TakeAfter(context, var);
    const ExprId init = Unwrap(context, assign->value);
    DeclareTemporaries(context);
    temporaries = later;
    context.stmts.push_back(context.At(span).Stmt(Declare{var, init}));
    return;
  }
  // The target is evaluated first; a path without side effects does not care.
  if (IsPure(context.program, target)) {
    const ExprId inner = Unwrap(context, assign->value);
    context.Get<Assign>(value).value = inner;
  }
  Emit(context, span, Evaluate{value});
}

ExprId Unwrap(Context& context, ExprId value) {
  while (const auto* comma = context.GetIf<Comma>(value)) {
    const ExprId second = comma->second;
    EmitValue(context, comma->first);
    value = second;
  }
  return value;
}

}  // namespace clipc::check
