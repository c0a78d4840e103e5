// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "ir/program.h"

namespace clipc::legalize {

// Tells divisors of integers that may be 0 from those that cannot be.
class Divisors {
 public:
  explicit Divisors(const ir::Program& program) : program_(program) {}

  // Whether a component of `divisor`, an integer or a vector of them, may be 0. It cannot in
  // constants, `x | 1`, `max(x, 1u)`, `1 << n` and what is put together from such, nor in a
  // variable that has one value, which cannot be 0. Of other expressions nothing is known.
  bool MayBeZero(ir::ExprId divisor) { return MayBeZero(divisor, 0); }

 private:
  // What a variable is given: nothing, one value, or more than that.
  struct Given {
    int times = 0;
    ir::ExprId value;
  };

  bool MayBeZero(ir::ExprId expr, int depth);
  bool MayBeZero(const ir::Binary& node, int depth);
  bool MayBeZero(const ir::IntrinsicCall& node, int depth);
  // Whether all components are constants above 0; for an unsigned number, not 0.
  bool IsAboveZero(ir::ExprId expr) const;
  ir::ExprId ValueOf(ir::VarId var);
  void FindValues();

  const ir::Program& program_;
  std::vector<Given> given_;  // by VarId, once a variable was asked for
};

}  // namespace clipc::legalize
