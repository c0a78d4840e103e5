// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/value_graph.h"

#include <cstdint>

#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::ir {

ValueGraph::ValueGraph(const Program& program)
    : program_(program), vars_(program.vars.size()), sources_(vars_ + program.functions.size()) {
  for (const VarId id : program.vars.ids()) AddValue(NodeOf(id), program.vars[id].init);
  for (const FunctionId id : program.functions.ids()) AddFunction(id);
}

std::size_t ValueGraph::AddNode() {
  sources_.emplace_back();
  return sources_.size() - 1;
}

void ValueGraph::SpreadToUses(std::vector<bool>& nodes) const {
  Edges uses(sources_.size());
  for (std::size_t node = 0; node < sources_.size(); ++node) {
    for (const std::size_t source : sources_[node]) uses[source].push_back(node);
  }
  Spread(uses, nodes);
}

void ValueGraph::Spread(const Edges& edges, std::vector<bool>& nodes) {
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i]) waiting.push_back(i);
  }
  while (!waiting.empty()) {
    const std::size_t node = waiting.back();
    waiting.pop_back();
    for (const std::size_t next : edges[node]) {
      if (nodes[next]) continue;
      nodes[next] = true;
      waiting.push_back(next);
    }
  }
}

void ValueGraph::AddFunction(FunctionId id) {
  const StmtId body = program_.functions[id].body;
  ForEachStmt(program_, body, [&](StmtId stmt) {
    if (const auto* declare = As<Declare>(program_, stmt))
      AddValue(NodeOf(declare->var), declare->init);
    if (const auto* result = As<Return>(program_, stmt)) AddValue(NodeOf(id), result->value);
  });
  ForEachExpr(program_, body, [&](ExprId expr) { AddWrites(expr); });
}

void ValueGraph::AddWrites(ExprId expr) {
  if (const auto* assign = As<Assign>(program_, expr)) return AddTo(assign->target, assign->value);
  if (const auto* call = As<Call>(program_, expr)) return AddArguments(*call);
  if (const auto* call = As<IntrinsicCall>(program_, expr)) {
    ForEachWrite(program_, expr, [&](ExprId target) {
      for (const ExprId argument : program_.expr_lists[call->arguments]) AddTo(target, argument);
    });
  }
}

void ValueGraph::AddArguments(const Call& call) {
  const std::vector<VarId>& parameters = program_.functions[call.function].parameters;
  for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
    const ExprId argument = program_.expr_lists[call.arguments][i];
    const Storage storage = program_.vars[parameters[i]].storage;
    const VarId target = storage == Storage::kIn ? VarId{} : RootOf(program_, argument);
    if (target) sources_[NodeOf(target)].push_back(NodeOf(parameters[i]));
    if (storage != Storage::kOut) AddValue(NodeOf(parameters[i]), argument);
  }
}

void ValueGraph::AddTo(ExprId target, ExprId value) {
  if (const VarId root = RootOf(program_, target)) AddValue(NodeOf(root), value);
}

void ValueGraph::AddValue(std::size_t node, ExprId value) {
  if (!value) return;
  values_.push_back({node, value});
  ForEachExpr(program_, value, [&](ExprId id) {
    if (const auto* ref = As<VarRef>(program_, id)) sources_[node].push_back(NodeOf(ref->var));
    if (const auto* call = As<Call>(program_, id)) sources_[node].push_back(NodeOf(call->function));
  });
}

}  // namespace clipc::ir
