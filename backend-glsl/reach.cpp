// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/reach.h"

#include <utility>

#include "ir/access.h"
#include "ir/call_order.h"
#include "ir/walk.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// Whether some target has no such function of GLSL, in any number of its versions.
bool MayBeLacking(Intrinsic op) {
  switch (CategoryOf(op)) {
    case IntrinsicCategory::kWave:
    case IntrinsicCategory::kQuad:
    case IntrinsicCategory::kInterpolants:
    case IntrinsicCategory::kMemory: return true;
    default:
      return op == CommonIntrinsic::kNonUniform || op == CommonIntrinsic::kCheckAccessFullyMapped ||
             InfoOf(op).gate != TargetGate::kNone;
  }
}

class Walker {
 public:
  explicit Walker(const Program& program) : program_(program) {
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
  void Functions() {
    const auto visit = [&](ExprId id, const Expr& expr) {
      if (const auto* ref = std::get_if<VarRef>(&expr.node)) return Variable(ref->var);
      const auto* call = std::get_if<IntrinsicCall>(&expr.node);
      if (std::holds_alternative<ObjectCall>(expr.node) || (call && MayBeLacking(call->op)))
        reached_.asked.push_back(id);
    };
    const auto enters = [&](FunctionId id) {
      return !program_.functions[id].is_helper || program_.functions[id].is_accessor;
    };
    reached_.functions = CalleesFirst(program_, visit, enters);
    std::erase_if(reached_.functions,
                  [&](FunctionId id) { return program_.functions[id].is_accessor; });
  }

  void Variable(VarId id) {
    if (reached_.Has(id)) return;
    reached_.vars[id.index] = true;
    const Var& var = program_.vars[id];
    if (var.cbuffer) reached_.cbuffers[var.cbuffer.index] = true;
    if ((var.storage != Storage::kStatic && var.storage != Storage::kConstant) || !var.init) return;
    ForEachExpr(program_, var.init, [&](ExprId expr) {
      if (const auto* ref = As<VarRef>(program_, expr)) Variable(ref->var);
    });
  }

  const Program& program_;
  Reached reached_;
};

}  // namespace

Reached Reach(const Program& program, bool keeps_bindings) {
  Reached reached = Walker(program).Run();
  if (!keeps_bindings) return reached;
  // An object that nothing uses may have no kind.
  for (const Resource& resource : program.resources) {
    const Type& type = program.types[program.types.Innermost(program.vars[resource.var].type)];
    if (InfoOf(type.object).category != ObjectCategory::kOther)
      reached.vars[resource.var.index] = true;
  }
  for (const CbufferId id : program.cbuffers.ids()) {
    reached.cbuffers[id.index] = true;
    for (const CbufferMember& member : program.cbuffers[id].members)
      reached.vars[member.var.index] = true;
  }
  return reached;
}

}  // namespace clipc::glsl
