// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "frontend/rules/rules.h"

// The variables that offsets of texture reads depend on, for KnowOffsets.
namespace clipc::rules {

// The number of the first argument that is an offset.
std::uint32_t FirstOffset(ObjectOp op);
bool IsLiteralOffset(const Program& program, ExprId offset);

// The variables and functions that offsets depend on, found before KnowOffsets changes the program.
// An offset depends on the variables that it names, on the variables that their initialisers name,
// on the bounds of the loops that count them, and on the arguments of parameters among them.
class WantedValues {
 public:
  explicit WantedValues(const Program& program);

  bool IsEmpty() const { return is_empty_; }  // every offset is a literal
  bool Has(VarId var) const { return var.index < vars_.size() && vars_[var.index]; }
  // Whether an offset that is not a literal is in the function, or in a function that it calls.
  bool Has(FunctionId function) const { return functions_[function.index]; }
  // Whether the variable is wanted and not assigned after its declaration.
  bool IsUnchanged(VarId var) const { return Has(var) && !assigned_[var.index]; }

  // The variable that a `for` loop counts with; `start` becomes the value that it starts from.
  VarId CounterOf(const For& loop, ExprId& start) const;
  // Whether the loop ends only by its condition, and the condition changes nothing.
  bool IsPlain(const For& loop) const;
  // The counter's value after the step, as an expression in the counter; none if the step does
  // something else.
  static ExprId NextOf(Program& program, ExprId step, VarId counter);

 private:
  // The expressions that a variable's value depends on, by VarId, and the callers of a function, by
  // FunctionId.
  struct Flows {
    std::vector<std::vector<ExprId>> values;
    std::vector<std::vector<FunctionId>> callers;
  };

  void FindOffsets();
  void Want(ExprId expr);
  void Collect(FunctionId function, Flows& flows) const;
  void FollowVars(const Flows& flows);
  void FollowFunctions(const Flows& flows);

  const Program& program_;
  std::vector<bool> vars_, functions_, assigned_;  // by VarId, FunctionId, VarId
  std::vector<VarId> waiting_;                     // variables that are wanted and not followed yet
  bool is_empty_ = true;
};

}  // namespace clipc::rules
