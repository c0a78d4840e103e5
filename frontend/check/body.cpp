// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/body.h"

#include <algorithm>
#include <span>

#include "frontend/check/assign.h"
#include "frontend/check/bit_field.h"
#include "frontend/check/emit.h"
#include "frontend/check/ends.h"
#include "frontend/check/enum_class.h"
#include "frontend/check/function.h"
#include "frontend/check/global.h"
#include "frontend/check/scope.h"
#include "frontend/check/stmt.h"
#include "frontend/check/type.h"

namespace clipc::check {
namespace {

void CheckBody(Context& context, FunctionInfoId id) {
  const FunctionInfo info = context[id];
  const ast::FunctionDecl& decl = DeclOf(context, info);
  const std::vector<VarId>& vars = context[info.function].parameters;
  Body body;
  body.function = info.function;
  body.return_type = info.return_type;
  body.written_return_type = decl.return_type;
  const ViewSwitch in(context, {.scope = info.scope,
                                .order = info.order,
                                .local_floor = context.names.size(),
                                .body = &body});
  const int errors_before = context.diagnostics.error_count();
  const ScopeTable::LocalScope parameter_scope(context.names);
  std::size_t next = 0;
  if (info.self) body.self = vars[next++];
  for (const Parameter& parameter : context[info.parameters]) {
    const auto& var = context.Get<ast::VarDecl>(parameter.decl);
    const SymbolId symbol =
        DeclareLocal(context, SymbolKind::kVariable, var.name, parameter.decl, var.name_span);
    NoteType(context, symbol, var);
    const VarId added = vars[next++];
    context[symbol].Resolve(added.index);
    if (parameter.storage != Storage::kOut || !HoldsBits(context, parameter.type)) continue;
    Builder at = context.At(var.name_span);
    body.hoisted.push_back(at.Eval(at.AssignTo(at.Ref(added), at.ZeroOf(parameter.type))));
  }
  const std::size_t mark = context.stmts.size();
  {
    const ScopeTable::LocalScope body_scope(context.names);
    CheckStmts(context, context.Get<ast::BlockStmt>(decl.body).body);
  }
  context.stmts.insert(context.stmts.begin() + static_cast<std::ptrdiff_t>(mark),
                       body.hoisted.begin(), body.hoisted.end());
  const StmtId block = context.At(context[decl.body].span).Stmt(Block{TakeStmts(context, mark)});
  context[info.function].body = block;
  const bool is_whole = context.diagnostics.error_count() == errors_before;
  if (is_whole) CheckEnd(context, info.function, decl.name_span);
}

}  // namespace

FunctionId Reach(Context& context, FunctionInfoId id) {
  FunctionInfo& info = context[id];
  if (info.function) return info.function;
  const ast::FunctionDecl& decl = DeclOf(context, info);
  Function function;
  function.name = context[decl.name];
  function.return_type = info.return_type;
  function.span = decl.name_span;
  function.precise = (decl.qualifiers & ast::kPrecise) != 0;
  function.parameters.reserve(info.parameters.size + 1u);
  if (info.self) {
    const Storage storage = info.changes_self ? Storage::kInOut : Storage::kIn;
    function.parameters.push_back(context.program.vars.Add(
        {.name = "self", .type = info.self, .storage = storage, .span = decl.name_span}));
    if (!info.changes_self) MarkConst(context, function.parameters.back());
  }
  for (const Parameter& parameter : context[info.parameters]) {
    const auto& var = context.Get<ast::VarDecl>(parameter.decl);
    const Span span = var.name ? var.name_span : context[parameter.decl].span;
    const VarId added =
        AddVar(context, var.name ? var.name : Name{}, parameter.type, parameter.storage, span);
    if (!var.name) context[added].name = "unused";
    context[added].precise = (var.qualifiers & ast::kPrecise) != 0;
    if ((var.qualifiers & ast::kConst) && parameter.storage == Storage::kIn)
      MarkConst(context, added);
    if (InfoOf(context.program.stage).reads_vertices && IsPatch(context, var))
      context.globals.patches.push_back(added);
    function.parameters.push_back(added);
  }
  function.body = context.At(decl.name_span).BlockOf({});
  info.function = context.program.functions.Add(std::move(function));
  if (decl.body) context.functions.waiting.push_back(id);
  return info.function;
}

void CheckBodies(Context& context) {
  for (std::size_t i = 0;
       i < context.functions.waiting.size() && !context.diagnostics.TooManyErrors(); ++i)
    CheckBody(context, context.functions.waiting[i]);
}

void CheckRecursion(Context& context) {
  using Edge = Overloads::CallEdge;
  KeptVector<Edge>& calls = context.functions.calls;
  std::ranges::stable_sort(calls, {}, &Edge::caller);
  enum : std::uint8_t { kNew, kOpen, kDone };
  std::vector<std::uint8_t> state(context.program.functions.size(), kNew);
  struct Step {
    FunctionId function;
    std::span<const Edge> calls;  // the calls that are left
  };
  std::vector<Step> path;
  const auto enter = [&](FunctionId function) {
    state[function.index] = kOpen;
    path.push_back({function, std::ranges::equal_range(calls, function, {}, &Edge::caller)});
  };
  for (const Edge& first : calls) {
    if (state[first.caller.index] == kNew) enter(first.caller);
    while (!path.empty()) {
      Step& step = path.back();
      if (step.calls.empty()) {
        state[step.function.index] = kDone;
        path.pop_back();
        continue;
      }
      const Edge& edge = step.calls.front();
      step.calls = step.calls.subspan(1);
      if (state[edge.callee.index] == kOpen) {
        const Function& callee = context[edge.callee];
        context.Report(edge.span, diag::Recursion, callee.name)
            .Note(callee.span, diag::DeclaredHere, callee.name);
      } else if (state[edge.callee.index] == kNew) {
        enter(edge.callee);
      }
    }
  }
}

}  // namespace clipc::check
