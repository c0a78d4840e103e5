// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/inline_entry.h"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "passes/split_variables.h"

namespace clipc::passes {

using namespace ir;

namespace {

class Inliner {
 public:
  explicit Inliner(Program& program)
      : program_(program), builder_(program, program.functions[program.main].span) {}

  void Run() {
    const Function& main = program_.functions[program_.main];
    for (StmtId id : program_.stmt_lists[std::get<Block>(program_.stmts[main.body].node).body])
      stmts_.push_back(id);
    if (!FindCall()) return;
    MainParts parts;
    parts.before.assign(stmts_.begin(), stmts_.begin() + call_at_);
    parts.after.assign(stmts_.begin() + call_at_ + 1, stmts_.end());
    const bool is_inlined = ReturnsAtTheEnd();
    if (is_inlined) {
      TakeBody(parts.body);
      for (std::vector<StmtId>* part : {&parts.before, &parts.body, &parts.after}) {
        for (StmtId id : *part) Rename(id);
      }
    } else {
      parts.body = {stmts_[static_cast<std::size_t>(call_at_)]};
    }
    const StmtId whole = builder_.BlockOf(SplitVariables(program_, parts));
    program_.functions[program_.main].body = whole;
    if (!is_inlined) return;
    // What is left is a name.
    Function& left = program_.functions[program_.entry];
    left.body = builder_.BlockOf({});
    left.parameters.clear();
    left.return_type = program_.types.Void();
  }

 private:
  bool IsEntryCall(ExprId expr) const {
    const auto* call = expr ? std::get_if<Call>(&program_.exprs[expr].node) : nullptr;
    return call && call->function == program_.entry;
  }

  // `T result = entry(...);`, `output = entry(...);` or `entry(...);`
  bool FindCall() {
    for (std::size_t i = 0; i < stmts_.size(); ++i) {
      const auto& node = program_.stmts[stmts_[i]].node;
      if (const auto* declare = std::get_if<Declare>(&node)) call_ = declare->init;
      if (const auto* evaluate = std::get_if<Evaluate>(&node)) {
        const auto* assign = std::get_if<Assign>(&program_.exprs[evaluate->expr].node);
        call_ = assign && !assign->op ? assign->value : evaluate->expr;
      }
      call_at_ = static_cast<std::ptrdiff_t>(i);
      if (IsEntryCall(call_)) return true;
    }
    return false;
  }

  bool ReturnsAtTheEnd() {
    const auto list =
        program_.stmt_lists
            [std::get<Block>(program_.stmts[program_.functions[program_.entry].body].node).body];
    int returns = 0;
    for (StmtId id : list) CountReturns(id, returns);
    if (!list.empty()) {
      if (const auto* last = std::get_if<Return>(&program_.stmts[list.back()].node)) {
        returned_ = last->value;
        --returns;
        has_return_ = true;
      }
    }
    return returns == 0 &&
           (returned_ || program_.functions[program_.entry].return_type == program_.types.Void());
  }

  void CountReturns(StmtId id, int& returns) const {
    if (std::holds_alternative<Return>(program_.stmts[id].node)) ++returns;
    ForEachPart(program_, id, [](ExprId) {}, [&](StmtId part) { CountReturns(part, returns); });
  }

  // A parameter is the variable of `main` that is its argument, or an input or uniform that is not
  // assigned to; any other becomes a local variable that starts as the argument.
  void Parameters(const Function& entry, std::vector<StmtId>& body) {
    const List<ExprId> arguments = std::get<Call>(program_.exprs[call_].node).arguments;
    for (std::uint32_t i = 0; i < arguments.size; ++i) {
      const VarId parameter = entry.parameters[i];
      const ExprId argument = program_.expr_lists[arguments][i];
      const auto* ref = std::get_if<VarRef>(&program_.exprs[argument].node);
      const bool is_local = ref && program_.vars[ref->var].storage == Storage::kLocal;
      const bool is_precise = program_.vars[parameter].precise;
      const bool is_unchanged =
          ref && !is_precise && IsPlain(ref->var) && !IsAssigned(program_, entry.body, parameter);
      if (is_local || is_unchanged) {
        renamed_[parameter] = ref->var;
        program_.vars[ref->var].precise |= is_precise;
        continue;
      }
      program_.vars[parameter].storage = Storage::kLocal;
      body.push_back(builder_.Stmt(Declare{parameter, argument}));
    }
  }

  // Costs nothing to name again. Built-in inputs may stand for a computation.
  bool IsPlain(VarId var) const {
    if (program_.vars[var].storage == Storage::kUniform) return true;
    const auto input = std::ranges::find(program_.inputs, var, &IoVar::var);
    return input != program_.inputs.end() && input->builtin == Builtin::kNone;
  }

  void TakeBody(std::vector<StmtId>& body) {
    const Function entry = program_.functions[program_.entry];
    Parameters(entry, body);
    const auto list =
        std::as_const(program_).stmt_lists[std::get<Block>(program_.stmts[entry.body].node).body];
    body.insert(body.end(), list.begin(), list.end());
    if (has_return_) body.pop_back();
    Result(body);
  }

  // The statement of the call takes the value that the entry point returned.
  void Result(std::vector<StmtId>& body) {
    const StmtId statement = stmts_[static_cast<std::size_t>(call_at_)];
    auto& node = program_.stmts[statement].node;
    if (auto* declare = std::get_if<Declare>(&node)) {
      const auto* ref = std::get_if<VarRef>(&program_.exprs[returned_].node);
      if (ref && !program_.vars[declare->var].precise && MayStandFor(ref->var, declare->var)) {
        renamed_[declare->var] = ref->var;
        return;
      }
      declare->init = returned_;
    } else {
      auto* assign = std::get_if<Assign>(&program_.exprs[std::get<Evaluate>(node).expr].node);
      if (!assign) return;
      assign->value = returned_;
    }
    body.push_back(statement);
  }

  // Passes may have added assignments to the result; an input or a uniform takes none.
  bool MayStandFor(VarId returned, VarId result) const {
    const auto known = renamed_.find(returned);
    const VarId var = known == renamed_.end() ? returned : known->second;
    if (program_.vars[var].storage == Storage::kLocal) return true;
    return std::none_of(stmts_.begin() + call_at_ + 1, stmts_.end(),
                        [&](StmtId id) { return IsAssigned(program_, id, result); });
  }

  void Rename(StmtId id) {
    ForEachPart(
        program_, id, [&](ExprId expr) { Rename(expr); }, [&](StmtId part) { Rename(part); });
  }
  void Rename(ExprId id) {
    if (auto* ref = std::get_if<VarRef>(&program_.exprs[id].node)) {
      for (auto known = renamed_.find(ref->var); known != renamed_.end();
           known = renamed_.find(ref->var)) {
        ref->var = known->second;
      }
    }
    ForEachOperand(program_, id, [&](ExprId operand) { Rename(operand); });
  }

  Program& program_;
  Builder builder_;
  std::vector<StmtId> stmts_;
  std::ptrdiff_t call_at_ = 0;
  ExprId call_, returned_;
  bool has_return_ = false;
  std::map<VarId, VarId> renamed_;
};

}  // namespace

void InlineEntry(Program& program) {
  CLIPC_CHECK(program.form == Form::kTargetClipSpace);
  program.form = Form::kInlined;
  Inliner(program).Run();
}

}  // namespace clipc::passes
