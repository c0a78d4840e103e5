// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/inline_entry.h"

#include <algorithm>
#include <span>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "passes/outputs.h"

namespace clipc::passes {

using namespace ir;

namespace {

class Inliner {
 public:
  // Puts the body of `callee` in the place of its call, a statement of `block`.
  Inliner(Program& program, FunctionId callee, StmtId block)
      : program_(program),
        callee_(callee),
        block_(block),
        builder_(program, program.functions[program.main].span),
        renamed_(program.vars.size()) {}

  MainParts Run() {
    const auto body = program_.stmt_lists[std::get<Block>(program_.stmts[block_].node).body];
    const auto call = std::find_if(body.begin(), body.end(), [&](StmtId id) {
      call_ = CallIn(program_, id, callee_);
      return static_cast<bool>(call_);
    });
    if (call == body.end()) return {};
    const MainParts parts{static_cast<std::size_t>(call - body.begin()),
                          static_cast<std::size_t>(body.end() - call) - 1};
    if (ReturnsAtTheEnd()) {
      TakeBody({body.begin(), call}, *call, {call + 1, body.end()});
      EmptyCallee();
    }
    return parts;
  }

 private:
  bool ReturnsAtTheEnd() {
    const Function& callee = program_.functions[callee_];
    int returns = 0;
    ForEachStmt(program_, callee.body,
                [&](StmtId id) { returns += As<Return>(program_, id) != nullptr; });
    const auto body = BodyOf(program_, callee_);
    const auto* last = body.empty() ? nullptr : As<Return>(program_, body.back());
    if (last) returned_ = last->value;
    has_return_ = last != nullptr;
    return returns == (last ? 1 : 0) && (returned_ || callee.return_type == program_.types.Void());
  }

  // Replaces a parameter by its argument if that is a local variable of `main`, or if it is a
  // uniform or an input that is not built in, and the parameter is neither precise nor assigned to.
  // Any other parameter becomes a local variable that starts as the argument.
  void Parameters(const Function& callee, std::vector<StmtId>& body) {
    const List<ExprId> arguments = std::get<Call>(program_.exprs[call_].node).arguments;
    std::vector<bool> assigned;  // by VarId; filled at the first question
    const auto is_assigned = [&](VarId var) {
      if (assigned.empty()) assigned = AssignedIn(program_, {&callee.body, 1});
      return assigned[var.index];
    };
    for (std::uint32_t i = 0; i < arguments.size; ++i) {
      const VarId parameter = callee.parameters[i];
      const ExprId argument = program_.expr_lists[arguments][i];
      const auto* ref = As<VarRef>(program_, argument);
      const bool is_local = ref && program_.vars[ref->var].storage == Storage::kLocal;
      const bool is_precise = program_.vars[parameter].precise;
      const bool is_unchanged =
          !is_local && ref && !is_precise && IsPlain(ref->var) && !is_assigned(parameter);
      if (is_local || is_unchanged) {
        renamed_[parameter.index] = ref->var;
        program_.vars[ref->var].precise |= is_precise;
        continue;
      }
      program_.vars[parameter].storage = Storage::kLocal;
      body.push_back(builder_.Stmt(Declare{parameter, argument}));
    }
  }

  // Whether naming the variable again costs nothing.
  bool IsPlain(VarId var) const {
    return program_.vars[var].storage == Storage::kUniform || IsPlainInput(program_, var);
  }

  // Puts the function's statements in the place of its call, under the names of `main`. `all`
  // has the statements before the call, `outputs` those after it.
  void TakeBody(std::vector<StmtId> all, StmtId call, const std::vector<StmtId>& outputs) {
    Parameters(program_.functions[callee_], all);
    const auto body = BodyOf(program_, callee_);
    all.insert(all.end(), body.begin(), body.end());
    if (has_return_) all.pop_back();
    if (Result(call, outputs)) all.push_back(call);
    all.insert(all.end(), outputs.begin(), outputs.end());
    Rename();
    program_.stmts[block_].node = Block{program_.stmt_lists.Add(std::span<const StmtId>(all))};
  }

  // Makes the statement of the call take the value that the function returns. Returns whether
  // that statement is still needed.
  bool Result(StmtId call, const std::vector<StmtId>& outputs) {
    auto& node = program_.stmts[call].node;
    if (auto* declare = std::get_if<Declare>(&node)) {
      const auto* ref = As<VarRef>(program_, returned_);
      if (ref && !program_.vars[declare->var].precise &&
          MayStandFor(ref->var, declare->var, outputs)) {
        renamed_[declare->var.index] = ref->var;
        return false;
      }
      declare->init = returned_;
    } else {
      auto* assign = std::get_if<Assign>(&program_.exprs[std::get<Evaluate>(node).expr].node);
      if (!assign) return false;
      assign->value = returned_;
    }
    return true;
  }

  // Whether the returned variable may take the place of the result. Passes may have added
  // assignments to the result, and an input or a uniform cannot be assigned to.
  bool MayStandFor(VarId returned, VarId result, const std::vector<StmtId>& outputs) const {
    const VarId name = renamed_[returned.index];
    const VarId var = name ? name : returned;
    return program_.vars[var].storage == Storage::kLocal ||
           !AssignedIn(program_, outputs)[result.index];
  }

  // Only the function and `main` name what is renamed.
  void Rename() {
    program_.exprs.ForEach([&](ExprId, Expr& expr) {
      auto* ref = std::get_if<VarRef>(&expr.node);
      if (!ref) return;
      while (const VarId name = renamed_[ref->var.index]) ref->var = name;
    });
  }

  // Removes all of the function but its name.
  void EmptyCallee() {
    Function& callee = program_.functions[callee_];
    callee.body = builder_.BlockOf({});
    callee.parameters.clear();
    callee.return_type = program_.types.Void();
  }

  Program& program_;
  FunctionId callee_;
  StmtId block_;
  Builder builder_;
  ExprId call_, returned_;
  bool has_return_ = false;
  std::vector<VarId> renamed_;  // by VarId
};

bool IsCalledOnce(const Program& program, FunctionId callee) {
  int calls = 0;
  for (const FunctionId function : program.functions.ids()) {
    ForEachExpr(program, program.functions[function].body, [&](ExprId id) {
      const auto* call = As<Call>(program, id);
      calls += call && call->function == callee ? 1 : 0;
    });
  }
  return calls == 1;
}

}  // namespace

MainParts InlineEntry(Program& program) {
  CLIPC_CHECK(program.form == Form::kTargetClipSpace);
  program.form = Form::kInlined;
  const MainParts parts =
      Inliner(program, program.entry, program.functions[program.main].body).Run();
  // The function of the patch's constants has its place in `main` too.
  const FunctionId constants = program.tessellation.patch_function;
  if (const StmtId block = PatchBlock(program); block && IsCalledOnce(program, constants))
    Inliner(program, constants, block).Run();
  return parts;
}

}  // namespace clipc::passes
