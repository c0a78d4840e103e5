// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <vector>

#include "frontend/rules/names.h"
#include "ir/value_graph.h"

namespace clipc::rules {

// What can be said of the paths of a program. What it needs is made when it is first asked.
class WrittenPaths {
 public:
  explicit WrittenPaths(const Program& program) : program_(program) {}

  // Whether the value may depend on a constant that a call gives to a parameter, or that a local
  // variable of bool or an integer gets: fxc folds the former, and the latter may be a flag that
  // goes with what is written.
  bool HasKnownCases(ExprId value);
  // Whether the head of the loop compares what the application may give any value to, so that the
  // loop may have no iteration: `i < count` with a uniform. False where that is not certain.
  bool MayNotRun(StmtId loop);

 private:
  // What a variable or number in a condition is.
  enum class Source { kNumber, kInput, kUncertain };

  void MakeGraph();
  bool MayFail(ExprId condition);
  Source SourceOf(ExprId value, int depth);
  Source SourceOf(VarId var, int depth);

  const Program& program_;
  std::optional<ValueGraph> graph_;
  // By node of the graph: what depends on constant arguments, and on flags too.
  std::vector<bool> by_calls_, has_cases_;
};

}  // namespace clipc::rules
