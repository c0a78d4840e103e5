// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "ir/clone_body.h"
#include "ir/program.h"

// What a target with Needs::constant_loops refuses unless it is unrolled or folded.
namespace clipc::legalize {

class Refused {
 public:
  explicit Refused(const ir::Program& program);

  // Whether any function that `main` may call has a refused part.
  bool IsAny() const { return functions_[program_.main.index]; }
  // Whether the function, or one that it calls, has a refused part.
  bool Has(ir::FunctionId function) const { return functions_[function.index]; }
  // Whether a refused part depends on the variable.
  bool IsSource(ir::VarId var) const { return Marks(sources_, var); }
  // Whether the expression is an index that must be constant, and is not, even if all counters of
  // loops are.
  bool IsRefusedIndex(ir::ExprId expr) const;
  // Whether a counter that the loop's head does not declare is used outside of loops that it
  // counts.
  bool IsUsedOutside(ir::VarId counter) const { return Marks(outside_, counter); }
  // Gives new variables the answers of the variables that they are copies of.
  void AddCopies(const ir::BodyCloner& cloner);

 private:
  // New variables that are copies of none have no mark.
  static bool Marks(const std::vector<bool>& marks, ir::VarId var) {
    return var.index < marks.size() && marks[var.index];
  }
  void ReadFunction(ir::FunctionId id, std::vector<ir::ExprId>& roots);
  void CountUses(ir::StmtId body);
  void FindSources(const std::vector<ir::ExprId>& roots);

  const ir::Program& program_;
  std::vector<char> counters_;  // by VarId: those of loops of every kind
  std::vector<bool> functions_, sources_, outside_;
};

}  // namespace clipc::legalize
