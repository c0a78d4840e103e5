// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <vector>

#include "ir/program.h"

namespace clipc::ir {

// The variables of a program, and its functions for their results, as nodes; an edge leads from
// each to those that its value is made of, by whatever expression. The order of statements does not
// count: a variable is one node wherever it is written.
class ValueGraph {
 public:
  // A value that goes to a node.
  struct Value {
    std::size_t node;
    ExprId expr;
  };

  explicit ValueGraph(const Program& program);

  // A node of the caller's own.
  std::size_t AddNode();
  // An edge that the program's values alone do not give.
  void AddSource(std::size_t node, std::size_t source) { sources_[node].push_back(source); }
  // Adds `value` and the edges from the node to its sources; nothing if `value` is none.
  void AddValue(std::size_t node, ExprId value);

  std::size_t NodeOf(VarId id) const { return id.index; }
  std::size_t NodeOf(FunctionId id) const { return vars_ + id.index; }
  std::size_t size() const { return sources_.size(); }
  const std::vector<Value>& values() const { return values_; }

  // Marks all nodes that the values of marked nodes are made of. `nodes` has size() marks.
  void SpreadToSources(std::vector<bool>& nodes) const { Spread(sources_, nodes); }
  // Marks all nodes whose values are made of marked nodes. `nodes` has size() marks.
  void SpreadToUses(std::vector<bool>& nodes) const;

 private:
  using Edges = std::vector<std::vector<std::size_t>>;

  static void Spread(const Edges& edges, std::vector<bool>& nodes);
  void AddFunction(FunctionId id);
  void AddWrites(ExprId expr);
  void AddArguments(const Call& call);
  void AddTo(ExprId target, ExprId value);

  const Program& program_;
  std::size_t vars_;  // the number of variables when the graph was made
  Edges sources_;
  std::vector<Value> values_;
};

}  // namespace clipc::ir
