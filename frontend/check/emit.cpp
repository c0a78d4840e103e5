// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/emit.h"

#include <algorithm>

namespace clipc::check {
namespace {

// Removes `var` and the temporaries made after it from the list. Returns those after it.
std::vector<ir::VarId> TakeAfter(Context& context, ir::VarId var) {
  std::vector<ir::VarId>& temporaries = context.view.body->temporaries;
  const auto found = std::ranges::find(temporaries, var);
  if (found == temporaries.end()) return {};
  std::vector<ir::VarId> later(found + 1, temporaries.end());
  temporaries.erase(found, temporaries.end());
  return later;
}

}  // namespace

void Emit(Context& context, Span span, decltype(ir::Stmt::node) node) {
  DeclareTemporaries(context);
  context.stmts.push_back(context.At(span).Stmt(std::move(node)));
}

std::vector<ir::StmtId> TakeStmts(Context& context, std::size_t mark) {
  const std::vector<ir::StmtId> taken(context.stmts.begin() + static_cast<std::ptrdiff_t>(mark),
                                      context.stmts.end());
  context.stmts.resize(mark);
  return taken;
}

void DeclareTemporaries(Context& context) {
  for (ir::VarId var : context.view.body->temporaries) {
    context.stmts.push_back(context.At(context[var].span).Stmt(ir::Declare{var, {}}));
  }
  context.view.body->temporaries.clear();
}

void EmitValue(Context& context, ir::ExprId value) {
  const ir::Expr& expr = context[value];
  const Span span = expr.span;
  if (const auto* comma = std::get_if<ir::Comma>(&expr.node)) {
    const ir::ExprId second = comma->second;
    EmitValue(context, comma->first);
    if (!context.Is<ir::VarRef>(second)) EmitValue(context, second);
    return;
  }
  const auto* assign = std::get_if<ir::Assign>(&expr.node);
  if (!assign) return Emit(context, span, ir::Evaluate{value});
  const ir::ExprId target = assign->target;
  const auto* ref = context.GetIf<ir::VarRef>(target);
  std::vector<ir::VarId>& temporaries = context.view.body->temporaries;
  const auto found = ref ? std::ranges::find(temporaries, ref->var) : temporaries.end();
  if (found != temporaries.end()) {
    const ir::VarId var = *found;
    const ir::ExprId init = Unwrap(context, assign->value);
    // The value may use temporaries that were made before this one.
    const std::vector<ir::VarId> later = TakeAfter(context, var);
    DeclareTemporaries(context);
    temporaries = later;
    context.stmts.push_back(context.At(span).Stmt(ir::Declare{var, init}));
    return;
  }
  // The target is evaluated first; a path without side effects does not care.
  if (ir::IsPure(context.program, target)) {
    const ir::ExprId inner = Unwrap(context, assign->value);
    context.Get<ir::Assign>(value).value = inner;
  }
  Emit(context, span, ir::Evaluate{value});
}

ir::ExprId Unwrap(Context& context, ir::ExprId value) {
  while (const auto* comma = context.GetIf<ir::Comma>(value)) {
    const ir::ExprId second = comma->second;
    EmitValue(context, comma->first);
    value = second;
  }
  return value;
}

}  // namespace clipc::check
