// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/ends.h"

#include <set>
#include <span>
#include <utility>
#include <vector>

#include "frontend/check/flow.h"
#include "frontend/typing/constant.h"
#include "ir/call_order.h"
#include "ir/evaluate.h"
#include "ir/walk.h"

namespace clipc::check {
namespace {

void ReportEnd(Context& context, const Overloads::OpenEnd& end) {
  const Function& function = context[end.function];
  context.Report(end.name, diag::NotAllPathsReturn, function.name,
                 context.TypeName(function.return_type));
}

// Walks the calls that lead to functions with open ends, each with the constants among its
// arguments: these are the values of its parameters while the function is walked.
class CallWalk {
 public:
  explicit CallWalk(Context& context)
      : context_(context),
        program_(context.program),
        ends_(program_.functions.size()),
        leads_(program_.functions.size()) {}

  void Run() {
    for (const Overloads::OpenEnd& end : context_.functions.open_ends)
      ends_[end.function.index] = &end;
    for (const FunctionId id : CalleesFirst(program_)) {
      leads_[id.index] = ends_[id.index] != nullptr;
      ForEachExpr(program_, program_.functions[id].body, [&](ExprId expr) {
        const auto* call = As<Call>(program_, expr);
        if (call && leads_[call->function.index]) leads_[id.index] = true;
      });
    }
    Add({program_.main, {}});
    for (std::size_t i = 0; i < calls_.size(); ++i) WalkFunction(FunctionCall(calls_[i]));
  }

 private:
  using Bits = std::vector<std::uint64_t>;
  struct FunctionCall {
    FunctionId function;
    std::vector<Bits> arguments;  // empty for what is not known
    bool operator<(const FunctionCall& other) const {
      return std::pair(function.index, arguments) <
             std::pair(other.function.index, other.arguments);
    }
  };

  void Add(FunctionCall call) {
    if (leads_[call.function.index] && seen_.insert(call).second) calls_.push_back(std::move(call));
  }

  // Makes the variable a constant until the end of the walk of its function.
  void SetKnown(VarId id, ExprId value) {
    known_.push_back({id, program_.vars[id].storage});
    program_.vars[id].storage = Storage::kConstant;
    program_.vars[id].init = value;
  }

  void WalkFunction(const FunctionCall& call) {
    const Function& function = program_.functions[call.function];
    const StmtId body = function.body;
    assigned_ = AssignedIn(program_, {&body, 1});
    bool has_constants = false;
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
      const VarId parameter = function.parameters[i];
      if (call.arguments[i].empty() || assigned_[parameter.index]) continue;
      has_constants = true;
      const TypeId type = program_.vars[parameter].type;
      SetKnown(parameter, context_.At(function.span).ValueOf(type, call.arguments[i]));
    }
    Walk(body);
    if (const Overloads::OpenEnd* end = ends_[call.function.index]) Judge(*end, has_constants);
    for (const auto& [id, storage] : known_) {
      program_.vars[id].storage = storage;
      program_.vars[id].init = {};
    }
    known_.clear();
  }

  void Judge(const Overloads::OpenEnd& end, bool has_constants) {
    const Exits exits = ExitsOf(program_, program_.functions[end.function].body);
    const bool is_error = !exits.returns || !has_constants;
    if (!exits.falls || !reported_[is_error].insert(end.function).second) return;
    if (is_error) return ReportEnd(context_, end);
    context_.Report(end.name, diag::EndWithoutReturn, program_.functions[end.function].name);
  }

  // Adds the calls in the statements that control can reach.
  void Walk(StmtId id) {
    if (const auto* choice = As<If>(program_, id)) {
      AddCalls(choice->condition);
      const auto known = EvaluateInteger(program_, choice->condition);
      if (known.value_or(1) != 0) Walk(choice->then);
      if (known.value_or(0) == 0 && choice->otherwise) Walk(choice->otherwise);
      return;
    }
    ForEachPart(
        program_, id, [&](ExprId expr) { AddCalls(expr); }, [&](StmtId part) { Walk(part); });
    const auto* declare = As<Declare>(program_, id);
    if (!declare || !declare->init || assigned_[declare->var.index]) return;
    if (program_.vars[declare->var].storage == Storage::kLocal && !BitsOf(declare->init).empty())
      SetKnown(declare->var, declare->init);
  }

  void AddCalls(ExprId root) {
    ForEachExpr(program_, root, [&](ExprId expr) {
      const auto* call = As<Call>(program_, expr);
      if (!call || !leads_[call->function.index]) return;
      FunctionCall added{call->function, {}};
      for (const ExprId argument : program_.expr_lists[call->arguments])
        added.arguments.push_back(BitsOf(argument));
      Add(std::move(added));
    });
  }

  Bits BitsOf(ExprId value) const {
    if (!TypeOf(program_, value).IsNumeric()) return {};
    return ConstantBits(program_, value).value_or(Bits{});
  }

  Context& context_;
  Program& program_;
  std::vector<const Overloads::OpenEnd*> ends_;  // by FunctionId
  std::vector<bool> leads_;                      // by FunctionId
  std::set<FunctionCall> seen_;
  std::vector<FunctionCall> calls_;  // to walk
  std::vector<bool> assigned_;       // by VarId, in the function that is walked
  std::vector<std::pair<VarId, Storage>> known_;
  std::set<FunctionId> reported_[2];  // with a warning, and with an error
};

}  // namespace

void CheckEnd(Context& context, FunctionId id, Span name) {
  const Function& function = context[id];
  if (function.return_type == context.types.Void()) return;
  const Exits exits = ExitsOf(context.program, function.body);
  if (!exits.falls) return;
  const Overloads::OpenEnd end{id, name};
  const bool waits = exits.returns && !function.parameters.empty() &&
                     context[function.return_type].IsNumeric() &&
                     !context.program.profile.IsAtLeast(6, 0);
  if (!waits) return ReportEnd(context, end);
  context.functions.open_ends.push_back(end);
}

void JudgeEnds(Context& context) {
  if (context.functions.open_ends.empty() || context.diagnostics.has_errors()) return;
  CallWalk(context).Run();
  for (const Overloads::OpenEnd& end : context.functions.open_ends) {
    const Function& function = context[end.function];
    Builder at = context.At(end.name);
    const auto old = context[context.Get<Block>(function.body).body];
    std::vector<StmtId> statements(old.begin(), old.end());
    statements.push_back(at.Stmt(Return{at.ZeroOf(function.return_type)}));
    const List<StmtId> list = context.program.stmt_lists.Add(std::span<const StmtId>(statements));
    context.Get<Block>(function.body).body = list;
  }
}

}  // namespace clipc::check
