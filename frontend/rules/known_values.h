// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <vector>

#include "frontend/rules/names.h"
#include "ir/value_graph.h"

namespace clipc::rules {

// The values that are known before the shader runs to a compiler that unrolls the loops that count
// with known numbers and puts functions in the place of their calls, as fxc does for level 9. Known
// are constants, parameters whose arguments are known in every call, and values that are computed
// from these alone. A variable is known if every value that it gets is known, and so is whether it
// gets it: no assignment to it depends on a condition that is not known. Counters of loops of every
// kind are such variables, however many iterations the loops have.
class KnownValues {
 public:
  // What counts as known beside constants: nothing, or the uniforms too, from which a preshader of
  // an effect computes what is the same in all runs of a draw call.
  enum class Kind { kConstants, kUniforms };

  // Finds the known values of `program`. The variables `unknown` count as unknown whatever their
  // values are.
  explicit KnownValues(const Program& program, std::span<const VarId> unknown = {},
                       Kind kind = Kind::kConstants);

  bool Has(ExprId expr) const;

 private:
  const Program& program_;
  ir::ValueGraph graph_;
  std::vector<bool> unknown_;  // by node of the graph
};

}  // namespace clipc::rules
