// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/verify.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "base/overloaded.h"
#include "ir/access.h"
#include "ir/std_layout.h"
#include "ir/verifier.h"
#include "ir/verify_interface.h"

namespace clipc::ir {
namespace {

using Scope = ExprVerifier::Scope;

class ProgramVerifier {
 public:
  explicit ProgramVerifier(const Program& program)
      : program_(program), exprs_(program), has_parent_(program.stmts.size(), false) {}

  std::optional<std::string> Run(Form form) {
    if (program_.form < form) Fail("the program has not reached the form that is asked for");
    exprs_.legalized = form >= Form::kLegalized;
    if (auto problem = CheckInterface(program_)) Fail(*problem);
    if (exprs_.failed()) return exprs_.problem();
    for (CbufferId id : program_.cbuffers.ids()) {
      for (const CbufferMember& member : program_.cbuffers[id].members) Show(member.var);
    }
    for (const Resource& resource : program_.resources) {
      Show(resource.var);
      if (form >= Form::kAddressed) CheckAddressed(program_.vars[resource.var]);
    }
    for (const IoVar& io : program_.inputs) {
      if (IsShown(io)) Show(io.var);
    }
    CheckGlobals();
    CheckClipPlanes();
    for (FunctionId id : program_.functions.ids()) CheckFunction(id);
    CheckCallGraph();
    return exprs_.problem();
  }

 private:
  struct Loop {
    int loops = 0;
    int switches = 0;
  };

  void Fail(std::string what) { exprs_.Fail(std::move(what)); }
  bool Require(bool holds, std::string_view what) {
    if (!holds) Fail(std::string(what));
    return holds;
  }
  const Type& TypeOf(ExprId expr) const { return program_.types[program_.exprs[expr].type]; }
  void Show(VarId var) { exprs_.scope[var.index] = Scope::kVisible; }

  void CheckAddressed(const Var& object) {
    const Type& type = program_.types[program_.types.Innermost(object.type)];
    Require(!IsByteAddress(type.object), "a byte address buffer is a structured buffer of words");
    Require(!IsStructured(type.object) ||
                Std430(program_.types, type.element, object.row_major).has_value(),
            "the elements of a structured buffer lie as std430 has them");
  }

  void CheckGlobals() {
    for (VarId var : program_.globals) {
      if (exprs_.failed()) return;
      if (!Require(var.index < program_.vars.size(), "a global is not a variable of this program"))
        return;
      const Var& global = program_.vars[var];
      exprs_.where = "global " + global.name;
      const bool is_shared = global.storage == Storage::kShared;
      Require(
          is_shared || global.storage == Storage::kStatic || global.storage == Storage::kConstant,
          "a global is static, shared or a constant");
      Require(!is_shared || (!global.init && clipc::InfoOf(program_.stage).runs_in_groups),
              "a shared variable is of a group, and has no initialiser");
      Require(global.storage != Storage::kConstant || global.init, "a constant has a value");
      if (exprs_.scope[var.index] != Scope::kNotYet) Fail("it is declared twice");
      CheckInitialiser(global);
      Show(var);
    }
    exprs_.where.clear();
  }

  void CheckInitialiser(const Var& var) {
    if (!var.init) return;
    exprs_.CheckTree(var.init);
    if (exprs_.failed()) return;
    Require(program_.exprs[var.init].type == var.type, "the initialiser has the variable's type");
    Require(IsPure(program_, var.init), "an initialiser outside a function has no effect");
  }

  void CheckClipPlanes() {
    for (const ClipPlane& plane : program_.clip_planes) {
      if (exprs_.failed() || !plane.value) continue;
      exprs_.where = "clip plane `" + plane.text + "`";
      exprs_.CheckTree(plane.value);
      if (exprs_.failed()) return;
      Require(program_.types.Name(program_.exprs[plane.value].type) == "float4",
              "a clip plane is a float4");
      Require(IsPure(program_, plane.value), "a clip plane's value has no effect");
    }
    exprs_.where.clear();
  }

  // ---- functions and statements

  void CheckFunction(FunctionId id) {
    if (exprs_.failed()) return;
    const Function& function = program_.functions[id];
    function_ = &function;
    exprs_.where = "function " + function.name;
    exprs_.calls.clear();
    declared_.clear();
    const bool is_main = id == program_.main, writes = WritesOutputs(id);
    if (is_main) ShowInputs(Scope::kVisible);
    if (writes) ShowOutputs(Scope::kVisible);
    for (VarId parameter : function.parameters) CheckParameter(parameter);
    if (!exprs_.failed() &&
        Require(function.body.index < program_.stmts.size() &&
                    std::holds_alternative<Block>(program_.stmts[function.body].node),
                "a function's body is a block")) {
      CheckStmt(function.body, {});
    }
    LeaveScope(0);
    if (is_main) ShowInputs(Scope::kGone);
    if (writes) ShowOutputs(Scope::kGone);
    Require(exprs_.output_arrays == array_targets_,
            "an array of outputs is only the target of a statement");
    callees_.push_back(exprs_.calls);
    exprs_.where.clear();
  }

  // Whether the function is `main`, or in a stage that emits vertices one that emits one.
  bool WritesOutputs(FunctionId id) const {
    const auto& streams = program_.emission.streams;
    if (streams.empty()) return id == program_.main;
    return std::ranges::find(streams, id, &Stream::emit) != streams.end();
  }

  // Whether every function may read the input.
  bool IsShown(const IoVar& io) const {
    const auto evaluates = [](const IntrinsicCall& call) {
      return CategoryOf(call.op) == IntrinsicCategory::kInterpolants;
    };
    return IsReadAnywhere(io.builtin) ||
           (io.builtin == Builtin::kNone && MayHaveExpr<IntrinsicCall>(program_, evaluates));
  }

  void ShowInputs(Scope scope) {
    for (const IoVar& io : program_.inputs) {
      if (!IsShown(io)) exprs_.scope[io.var.index] = scope;
    }
  }

  void ShowOutputs(Scope scope) {
    for (const IoVar& io : program_.outputs) exprs_.scope[io.var.index] = scope;
  }

  void CheckParameter(VarId parameter) {
    if (!Require(parameter.index < program_.vars.size(),
                 "a parameter is not a variable of this program"))
      return;
    const Storage storage = program_.vars[parameter].storage;
    Require(storage == Storage::kIn || storage == Storage::kOut || storage == Storage::kInOut,
            "a parameter is in, out or inout");
    EnterScope(parameter);
  }

  void EnterScope(VarId var) {
    if (exprs_.scope[var.index] != Scope::kNotYet) {
      return Fail("variable " + program_.vars[var].name + " is declared twice");
    }
    Show(var);
    declared_.push_back(var);
  }

  void LeaveScope(std::size_t mark) {
    for (; declared_.size() > mark; declared_.pop_back())
      exprs_.scope[declared_.back().index] = Scope::kGone;
  }

  void CountArrayTarget(StmtId stmt) {
    const Assign* assign = exprs_.failed() ? nullptr : AsAssignment(program_, stmt);
    const VarId root = assign ? RootOf(program_, assign->target) : VarId{};
    if (root && IsOutputArray(program_, root)) ++array_targets_;
  }

  void CheckCondition(ExprId condition) {
    exprs_.CheckTree(condition);
    if (exprs_.failed()) return;
    const Type& type = TypeOf(condition);
    Require(type.kind == TypeKind::kScalar && type.scalar == Scalar::kBool,
            "a condition is a bool scalar");
  }

  void CheckList(List<StmtId> list, Loop loop) {
    const std::size_t mark = declared_.size();
    for (StmtId stmt : program_.stmt_lists[list]) CheckStmt(stmt, loop);
    LeaveScope(mark);
  }

  // A body that is not a block has a scope of its own too.
  void CheckBody(StmtId body, Loop loop) {
    const std::size_t mark = declared_.size();
    CheckStmt(body, loop);
    LeaveScope(mark);
  }

  void CheckStmt(StmtId id, Loop loop) {
    if (exprs_.failed()) return;
    if (!Require(id.index < program_.stmts.size(), "a statement is missing or not of this program"))
      return;
    if (!Require(!has_parent_[id.index], "a statement has two parents")) return;
    has_parent_[id.index] = true;
    const Loop inner{loop.loops + 1, loop.switches};
    std::visit(Overloaded{
                   [&](const Block& n) { CheckList(n.body, loop); },
                   [&](const Declare& n) { CheckDeclare(n); },
                   [&](const Evaluate& n) {
                     exprs_.CheckTree(n.expr);
                     CountArrayTarget(id);
                   },
                   [&](const If& n) {
                     CheckCondition(n.condition);
                     CheckBody(n.then, loop);
                     if (n.otherwise) CheckBody(n.otherwise, loop);
                   },
                   [&](const For& n) { CheckFor(n, inner); },
                   [&](const While& n) { CheckCondition(n.condition), CheckBody(n.body, inner); },
                   [&](const DoWhile& n) { CheckBody(n.body, inner), CheckCondition(n.condition); },
                   [&](const Switch& n) { CheckSwitch(n, {loop.loops, loop.switches + 1}); },
                   [&](const Return& n) { CheckReturn(n); },
                   [&](const Break&) {
                     Require(loop.loops + loop.switches > 0, "break stands in a loop or switch");
                   },
                   [&](const Continue&) { Require(loop.loops > 0, "continue stands in a loop"); },
                   [&](const Discard&) {
                     Require(clipc::InfoOf(program_.stage).draws_pixels, "a pixel is discarded");
                   },
               },
               program_.stmts[id].node);
  }

  void CheckDeclare(const Declare& node) {
    if (!Require(node.var.index < program_.vars.size(),
                 "a declaration of no variable of this program"))
      return;
    const Var& var = program_.vars[node.var];
    Require(var.storage == Storage::kLocal || var.storage == Storage::kConstant ||
                var.storage == Storage::kStatic,
            "only local, constant and static variables are declared by a statement");
    Require(program_.types[var.type].kind != TypeKind::kVoid, "a variable has a value");
    if (node.init) {
      exprs_.CheckTree(node.init);
      if (exprs_.failed()) return;
      Require(program_.exprs[node.init].type == var.type,
              "the initialiser has the variable's type");
    }
    CheckInitialiser(var);
    EnterScope(node.var);
  }

  void CheckFor(const For& node, Loop inner) {
    const std::size_t mark = declared_.size();
    for (StmtId init : program_.stmt_lists[node.init]) {
      CheckStmt(init, {});
      if (exprs_.failed()) return;
      const auto& stmt = program_.stmts[init].node;
      Require(std::holds_alternative<Declare>(stmt) ||
                  (std::holds_alternative<Evaluate>(stmt) && node.init.size == 1),
              "a for starts with declarations or one expression");
    }
    if (node.condition) CheckCondition(node.condition);
    if (node.step) exprs_.CheckTree(node.step);
    CheckBody(node.body, inner);
    LeaveScope(mark);
  }

  void CheckSwitch(const Switch& node, Loop inner) {
    exprs_.CheckTree(node.value);
    if (exprs_.failed()) return;
    const Type& type = TypeOf(node.value);
    Require(type.kind == TypeKind::kScalar && IsInteger(type.scalar),
            "a switch is over an int or uint scalar");
    std::vector<std::uint64_t> labels;
    int defaults = 0;
    const std::size_t mark = declared_.size();
    for (const SwitchCase& arm : program_.switch_cases[node.cases]) {
      defaults += arm.is_default ? 1 : 0;
      for (ExprId label : program_.expr_lists[arm.labels]) {
        exprs_.CheckTree(label);
        if (exprs_.failed()) return;
        const Literal* literal = std::get_if<Literal>(&program_.exprs[label].node);
        Require(literal && &TypeOf(label) == &type,
                "a case label is a literal of the switch's type");
        if (literal) labels.push_back(literal->bits);
      }
      // A variable that an arm declares is visible in the next arms, as in the text.
      for (StmtId stmt : program_.stmt_lists[arm.body]) CheckStmt(stmt, inner);
    }
    LeaveScope(mark);
    Require(defaults <= 1, "a switch has one default");
    CheckDistinct(std::move(labels));
  }

  void CheckDistinct(std::vector<std::uint64_t> labels) {
    std::sort(labels.begin(), labels.end());
    Require(std::adjacent_find(labels.begin(), labels.end()) == labels.end(),
            "two case labels are the same");
  }

  void CheckReturn(const Return& node) {
    const bool is_void = program_.types[function_->return_type].kind == TypeKind::kVoid;
    if (node.value) exprs_.CheckTree(node.value);
    if (exprs_.failed()) return;
    Require(is_void != bool{node.value}, "a return has a value exactly where the function has one");
    if (node.value) {
      Require(program_.exprs[node.value].type == function_->return_type,
              "a return has the function's type");
    }
  }

  // ---- calls

  void CheckCallGraph() {
    if (exprs_.failed()) return;
    state_.assign(program_.functions.size(), 0);
    for (FunctionId id : program_.functions.ids()) Visit(id);
    if (program_.entry && program_.main && program_.entry != program_.main &&
        program_.form < Form::kInlined) {
      const auto& calls = callees_[program_.main.index];
      Require(std::count(calls.begin(), calls.end(), program_.entry) == 1,
              "main calls the entry once");
    }
  }

  void Visit(FunctionId id) {
    std::uint8_t& state = state_[id.index];
    if (state == 1) Fail("function " + program_.functions[id].name + " can reach itself");
    if (state != 0) return;
    state = 1;
    for (FunctionId callee : callees_[id.index]) Visit(callee);
    state_[id.index] = 2;
  }

  const Program& program_;
  ExprVerifier exprs_;
  std::vector<bool> has_parent_;
  const Function* function_ = nullptr;
  std::vector<VarId> declared_;
  std::size_t array_targets_ = 0;  // statements that assign to an array of outputs
  std::vector<std::vector<FunctionId>> callees_;
  std::vector<std::uint8_t> state_;
};

}  // namespace

std::optional<std::string> Verify(const Program& program, Form form) {
  return ProgramVerifier(program).Run(form);
}

}  // namespace clipc::ir
