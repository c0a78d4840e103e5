// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "ir/program.h"

namespace clipc::legalize {

// The expressions that matter only as the index of an element or as the place in a texture or
// buffer: there, and in the variables, parameters, sums and products on the way there.
//
//   int4 i = int4(indices); ... bones[i.x * 3 + 1]   =>  int4(indices)
class IndexUses {
 public:
  // The program must not change while this lives.
  explicit IndexUses(const ir::Program& program);

  // Whether the expression, one that the program had at construction, is used as nothing but an
  // index.
  bool IsIndex(ir::ExprId expr) const {
    return expr.index < is_index_.size() && is_index_[expr.index];
  }

 private:
  // Counts the uses of variables, and finds their values; returns the indices and places.
  std::vector<ir::ExprId> FindUses();
  void AddValue(ir::VarId var, ir::ExprId value);
  void Mark(ir::ExprId expr);
  void Drop(ir::VarId var);

  const ir::Program& program_;
  std::vector<bool> is_index_;       // by ExprId
  std::vector<std::uint32_t> uses_;  // by VarId: references that are neither index nor target
  std::vector<std::vector<ir::ExprId>> values_;  // by VarId, of locals and `in` parameters
  std::vector<ir::VarId> waiting_;               // variables without uses left
};

}  // namespace clipc::legalize
