// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "frontend/rules/rules.h"

namespace clipc::rules {

// Which values are known before the shader runs to a compiler that unrolls the loops that count
// with known numbers and puts functions in the place of their calls, as fxc does for level 9. Known
// are constants, local variables that are set once to a known value, parameters whose arguments are
// known in every call, the counters of such `for` loops, and what is computed from these.
class KnownValues {
 public:
  explicit KnownValues(const Program& program);

  bool Has(ExprId expr) const;

 private:
  void Read(StmtId stmt);
  void ReadLoop(const For& loop);
  void ReadCalls(ExprId expr);

  const Program& program_;
  std::vector<bool> assigned_;  // by VarId: after its declaration
  std::vector<bool> known_;     // by VarId
  bool changed_ = false;        // a parameter turned out to be unknown
};

}  // namespace clipc::rules
