// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/reach.h"

#include <utility>
#include <variant>

#include "ir/walk.h"

namespace clipc::glsl {

using namespace ir;

namespace {

class Walker {
 public:
  explicit Walker(const Program& program) : program_(program), started_(program.functions.size()) {
    reached_.vars.resize(program.vars.size());
    reached_.cbuffers.resize(program.cbuffers.size());
  }

  Reached Run() {
    Functions();
    for (VarId global : program_.globals) {
      if (reached_.Has(global)) reached_.globals.push_back(global);
    }
    return std::move(reached_);
  }

 private:
  // A function whose callees are being visited.
  struct Visit {
    FunctionId function;
    std::vector<FunctionId> callees;
    std::size_t next = 0;
  };

  // Visits the functions depth first, without recursion: generated shaders have call chains of any
  // length.
  void Functions() {
    std::vector<Visit> stack{Start(program_.main)};
    while (!stack.empty()) {
      Visit& top = stack.back();
      if (top.next == top.callees.size()) {
        reached_.functions.push_back(top.function);
        stack.pop_back();
      } else if (const FunctionId callee = top.callees[top.next++]; !started_[callee.index]) {
        stack.push_back(Start(callee));
      }
    }
  }

  Visit Start(FunctionId id) {
    started_[id.index] = true;
    Visit visit{id, {}};
    ForEachExpr(program_, program_.functions[id].body, [&](ExprId expr) {
      const auto& node = program_.exprs[expr].node;
      if (const auto* ref = std::get_if<VarRef>(&node)) {
        Variable(ref->var);
      } else if (const auto* call = std::get_if<Call>(&node)) {
        if (!program_.functions[call->function].is_helper) visit.callees.push_back(call->function);
      }
    });
    return visit;
  }

  void Variable(VarId id) {
    if (reached_.Has(id)) return;
    reached_.vars[id.index] = true;
    const Var& var = program_.vars[id];
    if (var.cbuffer) reached_.cbuffers[var.cbuffer.index] = true;
    if ((var.storage != Storage::kStatic && var.storage != Storage::kConstant) || !var.init) return;
    ForEachExpr(program_, var.init, [&](ExprId expr) {
      if (const auto* ref = std::get_if<VarRef>(&program_.exprs[expr].node)) Variable(ref->var);
    });
  }

  const Program& program_;
  std::vector<bool> started_;
  Reached reached_;
};

}  // namespace

Reached Reach(const Program& program) { return Walker(program).Run(); }

}  // namespace clipc::glsl
