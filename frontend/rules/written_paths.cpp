// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/written_paths.h"

#include <algorithm>

#include "base/operators.h"
#include "base/overloaded.h"
#include "ir/access.h"
#include "ir/evaluate.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

constexpr int kMostSources = 8;  // that are followed from variable to variable

}  // namespace

void WrittenPaths::MakeGraph() {
  if (graph_) return;
  graph_.emplace(program_);
  by_calls_.resize(graph_->size());
  for (const FunctionId function : program_.functions.ids()) {
    ForEachExpr(program_, program_.functions[function].body, [&](ExprId expr) {
      const auto* call = As<Call>(program_, expr);
      if (!call) return;
      const std::vector<VarId>& parameters = program_.functions[call->function].parameters;
      for (std::uint32_t i = 0; i < call->arguments.size; ++i) {
        if (ConstantBits(program_, program_.expr_lists[call->arguments][i]))
          by_calls_[graph_->NodeOf(parameters[i])] = true;
      }
    });
  }
  has_cases_ = by_calls_;
  for (const ValueGraph::Value& given : graph_->values()) {
    if (given.node >= program_.vars.size()) continue;
    const Var& var = program_.vars[VarId{static_cast<std::uint32_t>(given.node)}];
    const Type& type = program_.types[var.type];
    const bool is_flag = var.storage == Storage::kLocal && type.kind == TypeKind::kScalar &&
                         (IsInteger(type.scalar) || type.scalar == Scalar::kBool);
    if (is_flag && ConstantBits(program_, given.expr)) has_cases_[given.node] = true;
  }
  graph_->SpreadToUses(by_calls_);
  graph_->SpreadToUses(has_cases_);
}

bool WrittenPaths::HasKnownCases(ExprId value) {
  MakeGraph();
  return AnyExpr(program_, value, [&](ExprId part) {
    const auto* ref = As<VarRef>(program_, part);
    const auto* call = As<Call>(program_, part);
    return (ref && has_cases_[graph_->NodeOf(ref->var)]) ||
           (call && has_cases_[graph_->NodeOf(call->function)]);
  });
}

bool WrittenPaths::MayNotRun(StmtId loop) {
  MakeGraph();
  if (const auto* counted = As<For>(program_, loop))
    return counted->condition && MayFail(counted->condition);
  const auto* loops = As<While>(program_, loop);
  return loops && MayFail(loops->condition);
}

// Whether the condition may be false when control first reaches it.
bool WrittenPaths::MayFail(ExprId condition) {
  if (const auto* binary = As<Binary>(program_, condition)) {
    if (binary->op == BinaryOp::kLogicalAnd || binary->op == BinaryOp::kShortCircuitAnd)
      return MayFail(binary->left) || MayFail(binary->right);
    if (!IsComparison(binary->op)) return false;
    const Source left = SourceOf(binary->left, 0), right = SourceOf(binary->right, 0);
    return left != Source::kUncertain && right != Source::kUncertain &&
           (left == Source::kInput || right == Source::kInput);
  }
  return SourceOf(condition, 0) == Source::kInput;
}

WrittenPaths::Source WrittenPaths::SourceOf(ExprId value, int depth) {
  if (ConstantBits(program_, value)) return Source::kNumber;
  return Visit(
      Overloaded{
          [&](const VarRef& node) { return SourceOf(node.var, depth); },
          [&](const OneOf<FieldRef, Swizzle> auto& node) { return SourceOf(node.base, depth); },
          [&](const Convert& node) { return SourceOf(node.operand, depth); },
          [&](const Construct& node) {
            Source all = Source::kNumber;
            for (const ExprId part : program_.expr_lists[node.arguments])
              all = std::max(all, SourceOf(part, depth));
            return all;
          },
          [](const auto&) { return Source::kUncertain; },
      },
      program_.exprs[value].node);
}

WrittenPaths::Source WrittenPaths::SourceOf(VarId var, int depth) {
  if (depth == kMostSources || by_calls_[graph_->NodeOf(var)]) return Source::kUncertain;
  switch (program_.vars[var].storage) {
    case Storage::kUniform:
    case Storage::kInput: return Source::kInput;
    case Storage::kIn:
    case Storage::kInOut:
    case Storage::kLocal: break;
    default: return Source::kUncertain;
  }
  bool has_value = false;
  Source all = Source::kNumber;
  for (const ValueGraph::Value& given : graph_->values()) {
    if (given.node != graph_->NodeOf(var)) continue;
    has_value = true;
    all = std::max(all, SourceOf(given.expr, depth + 1));
  }
  return has_value ? all : Source::kUncertain;
}

}  // namespace clipc::rules
