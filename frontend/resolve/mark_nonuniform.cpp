// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/mark_nonuniform.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "frontend/typing/constant.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "ir/value_graph.h"
#include "ir/walk.h"

namespace clipc::resolve {
namespace {

class NonUniformMarker {
 public:
  explicit NonUniformMarker(Program& program) : program_(program) {}

  void Run() {
    if (!program_.calls_nonuniform) return;
    std::vector<ExprId> calls, indices;
    ForEachLiveExpr(program_, [&](ExprId expr) {
      if (IsCall(expr)) calls.push_back(expr);
    });
    FollowValues();
    ForEachLiveExpr(program_, [&](ExprId expr) {
      const auto* index = As<Index>(program_, expr);
      if (index && ChoosesResource(index->base) && Differs(index->index)) indices.push_back(expr);
    });
    // An inner call is replaced before the outer one takes its place.
    for (auto call = calls.rbegin(); call != calls.rend(); ++call) Remove(*call);
    for (const ExprId index : indices) Mark(index);
  }

 private:
  bool IsCall(ExprId expr) const {
    const auto* call = As<IntrinsicCall>(program_, expr);
    return call && call->op == CommonIntrinsic::kNonUniform;
  }

  // Whether the elements of the expression are textures, samplers or buffers.
  bool ChoosesResource(ExprId base) const {
    const VarId root = RootOf(program_, base);
    if (!root || TypeOf(program_, base).kind != TypeKind::kArray) return false;
    const Var& var = program_.vars[root];
    if (var.storage == Storage::kResource) return true;
    ExprId whole = base;
    while (const auto* index = As<Index>(program_, whole)) whole = index->base;
    return var.storage == Storage::kUniform && As<VarRef>(program_, whole) &&
           program_.cbuffers[var.cbuffer].kind == CbufferKind::kConstantBuffer;
  }

  bool Differs(ExprId expr) const {
    return AnyExpr(program_, expr, [&](ExprId part) {
      if (const auto* ref = As<VarRef>(program_, part)) return bool(vars_[ref->var.index]);
      const auto* call = As<Call>(program_, part);
      return call ? bool(functions_[call->function.index]) : IsCall(part);
    });
  }

  void FollowValues() {
    const ValueGraph graph(program_);
    std::vector<bool> differs(graph.size());
    for (const ValueGraph::Value& value : graph.values()) {
      if (AnyExpr(program_, value.expr, [&](ExprId part) { return IsCall(part); }))
        differs[value.node] = true;
    }
    graph.SpreadToUses(differs);
    for (const VarId id : program_.vars.ids()) vars_.push_back(differs[graph.NodeOf(id)]);
    for (const FunctionId id : program_.functions.ids())
      functions_.push_back(differs[graph.NodeOf(id)]);
  }

  void Remove(ExprId expr) {
    const auto& call = std::get<IntrinsicCall>(program_.exprs[expr].node);
    const Expr operand = program_.exprs[program_.expr_lists[call.arguments][0]];
    program_.exprs[expr].node = operand.node;
  }

  void Mark(ExprId expr) {
    const Index index = std::get<Index>(program_.exprs[expr].node);
    if (EvaluateInteger(program_, index.index)) return;
    Builder at(program_, program_.exprs[index.index].span);
    const TypeId number = program_.types.Make(Scalar::kUint);
    const ExprId value = at.ConvertTo(Scalar::kUint, index.index);
    program_.exprs[expr].node =
        Index{index.base, at.IntrinsicOf(CommonIntrinsic::kNonUniform, number, {value})};
  }

  Program& program_;
  std::vector<bool> vars_;       // by VarId: whether its value may differ
  std::vector<bool> functions_;  // by FunctionId: whether its result may differ
};

}  // namespace

void MarkNonUniform(Program& program) { NonUniformMarker(program).Run(); }

}  // namespace clipc::resolve
