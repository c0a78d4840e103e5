// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/static_local.h"

#include <algorithm>
#include <vector>

#include "frontend/check/assign.h"
#include "frontend/check/emit.h"
#include "frontend/check/enum_class.h"
#include "frontend/check/global.h"
#include "frontend/check/init.h"
#include "frontend/check/scope.h"
#include "frontend/check/type.h"
#include "frontend/check/value.h"
#include "ir/call_order.h"
#include "ir/evaluate.h"
#include "ir/walk.h"

namespace clipc::check {
namespace {

// Whether the value is the same wherever it is computed.
bool IsSameEverywhere(const Context& context, ExprId value) {
  const Program& program = context.program;
  const auto may_differ = [&](ExprId part) {
    if (context.Is<Call>(part) || context.Is<ObjectCall>(part)) return true;
    if (const auto* call = context.GetIf<IntrinsicCall>(part))
      return CategoryOf(call->op) >= IntrinsicCategory::kWriting;
    const auto* ref = context.GetIf<VarRef>(part);
    if (!ref) return false;
    const Var& var = context[ref->var];
    const bool is_fixed =
        var.storage == Storage::kConstant || var.storage == Storage::kUniform ||
        (var.storage == Storage::kStatic && var.init && IsConstVar(context, ref->var));
    return !is_fixed;
  };
  return IsPure(program, value) && !AnyExpr(program, value, may_differ);
}

// The first parameter, or variable of the function that is not constant, that the value reads.
VarId FirstLocal(const Context& context, ExprId value) {
  VarId first;
  ForEachExpr(context.program, value, [&](ExprId part) {
    const auto* ref = context.GetIf<VarRef>(part);
    if (!ref || first) return;
    const Storage storage = context[ref->var].storage;
    const bool is_parameter =
        storage == Storage::kIn || storage == Storage::kOut || storage == Storage::kInOut;
    const bool is_local = storage == Storage::kLocal && !IsConstVar(context, ref->var) &&
                          std::ranges::find(context.view.body->temporaries, ref->var) ==
                              context.view.body->temporaries.end();
    if (is_parameter || is_local) first = ref->var;
  });
  return first;
}

// Puts the values of the function's constants in their place, which is not where static variables
// have theirs.
void TakeOutLocalConstants(Context& context, ExprId value) {
  std::vector<ExprId> refs;
  ForEachExpr(context.program, value, [&](ExprId part) {
    const auto* ref = context.GetIf<VarRef>(part);
    if (!ref || context[ref->var].storage != Storage::kConstant) return;
    if (std::ranges::find(context.globals.reached, ref->var, &Globals::Ordered::var) ==
        context.globals.reached.end())
      refs.push_back(part);
  });
  for (const ExprId ref : refs) {
    const auto bits = ConstantBits(context.program, ref);
    if (!bits) continue;
    Builder at = context.At(context[ref].span);
    context[ref].node = context[at.ValueOf(context.TypeIdOf(ref), *bits)].node;
  }
}

// Emits the statement that gives the variable its value once.
void EmitOnce(Context& context, VarId id, ExprId value, Span span) {
  const std::string name = context[id].name;
  Builder at = context.At(span);
  const VarId flag = at.Local(name + "_is_set", context.types.Make(Scalar::kBool));
  context[flag].storage = Storage::kStatic;
  context[flag].init = at.Bool(false);
  context.globals.reached.push_back({context.view.order, flag});
  const std::size_t mark = context.stmts.size();
  const ExprId last = Unwrap(context, value);
  Emit(context, span, Evaluate{at.AssignTo(at.Ref(id), last)});
  Emit(context, span, Evaluate{at.AssignTo(at.Ref(flag), at.Bool(true))});
  const StmtId block = at.Stmt(Block{TakeStmts(context, mark)});
  Emit(context, span, If{at.UnaryOf(UnaryOp::kNot, at.Ref(flag)), block, {}});
  const Body& body = *context.view.body;
  const bool may_repeat = body.loops + body.switches > 0;
  context.globals.late.push_back({id, flag, context.stmts.back(), body.function, may_repeat});
}

// Adds `each` for every call in the statement, and more in loops.
void CountCalls(const Program& program, StmtId id, int each, std::vector<int>& times) {
  const bool is_loop = As<For>(program, id) || As<While>(program, id) || As<DoWhile>(program, id);
  if (is_loop) each = 2;
  const auto count = [&](ExprId expr) {
    if (const auto* call = As<Call>(program, expr)) times[call->function.index] += each;
  };
  ForEachPart(
      program, id, [&](ExprId expr) { ForEachExpr(program, expr, count); },
      [&](StmtId part) { CountCalls(program, part, each, times); });
}

// How often control may reach each function: 0, 1 or more.
std::vector<int> TimesOfFunctions(const Program& program) {
  std::vector<int> times(program.functions.size());
  KeptVector<FunctionId> order = CalleesFirst(program);
  std::ranges::reverse(order);
  times[program.main.index] = 1;
  for (const FunctionId caller : order) {
    const int each = std::min(times[caller.index], 2);
    CountCalls(program, program.functions[caller].body, each, times);
  }
  return times;
}

}  // namespace

void CheckStaticLocal(Context& context, ast::DeclId id, const ast::VarDecl& var) {
  const TypeId type = ResolveVarType(context, var);
  const bool is_broken = context.IsError(type);
  const bool is_object = !is_broken && HoldsObjects(context, type);
  ExprId init;
  if (var.init && !is_broken && !is_object) {
    init = CheckInit(context, var.init, type);
    if (var.dimensions.empty()) CheckEnumClass(context, var.type, init);
  }
  const SymbolId symbol = DeclareLocal(context, SymbolKind::kVariable, var.name, id, var.name_span);
  context[symbol].resolution = Resolution::kDone;
  NoteType(context, symbol, var);
  if (is_broken || (init && context.IsError(init))) return;
  if (is_object) {
    View view = context.view;
    view.body = nullptr;
    const ViewSwitch in(context, view);
    return ResolveStatic(context, symbol, var);
  }
  const bool is_late = init && !IsSameEverywhere(context, init);
  if (is_late && !context.program.profile.IsAtLeast(6, 0)) {
    if (const VarId local = FirstLocal(context, init)) {
      const std::string& name = context[local].name;
      const bool is_self = local == context.view.body->self;
      context.Report(context[var.init].span, diag::StaticNotConstant, context[var.name],
                     is_self ? "this" : name);
    }
  }
  if (init && !is_late) TakeOutLocalConstants(context, init);
  const VarId added = AddStatic(context, symbol, var, type, is_late ? ExprId{} : init);
  if (is_late) EmitOnce(context, added, init, var.name_span);
}

void SettleStaticLocals(Context& context) {
  Program& program = context.program;
  if (context.globals.late.empty()) return;
  const std::vector<int> times = TimesOfFunctions(program);
  for (const Globals::Late& late : context.globals.late) {
    const StmtId block = context.Get<If>(late.stmt).then;
    const List<StmtId> steps = context.Get<Block>(block).body;
    if (late.may_repeat || times[late.function.index] > 1 || steps.size != 2) continue;
    const ExprId first = context.Get<Evaluate>(context[steps][0]).expr;
    context[late.var].storage = Storage::kLocal;
    program.stmts[late.stmt].node = Declare{late.var, context.Get<Assign>(first).value};
    std::erase_if(program.globals,
                  [&](VarId global) { return global == late.var || global == late.flag; });
  }
}

}  // namespace clipc::check
