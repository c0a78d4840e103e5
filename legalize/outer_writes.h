// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "ir/program.h"

namespace clipc::legalize {

// The variables outside a function that calls of it may write. What a function writes does not
// change while operands are lowered.
class OuterWrites {
 public:
  struct Set {
    std::vector<ir::VarId> vars;
    bool is_all = false;  // more than kMost: all variables count as written

    bool writes() const { return is_all || !vars.empty(); }
  };

  explicit OuterWrites(const ir::Program& program)
      : program_(program), sets_(program.functions.size()) {
    beyond_.is_all = true;
  }

  const Set& Of(ir::FunctionId function);

 private:
  static constexpr std::size_t kMost = 32;
  static constexpr int kMostCalls = 64;  // inside each other; a function below may write anything

  Set Find(ir::FunctionId function);
  void Add(Set& set, ir::VarId var);

  const ir::Program& program_;
  std::vector<std::unique_ptr<Set>> sets_;  // by FunctionId, once asked for
  Set beyond_;
  int depth_ = 0;
};

}  // namespace clipc::legalize
