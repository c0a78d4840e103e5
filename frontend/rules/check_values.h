// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "frontend/rules/names.h"

namespace clipc::rules {

// Reports operations whose operands make them fail: a division by a constant 0 (fxc X4008 of
// floats, a warning; X4009 of integers, an error, as dxc's validator has it) and, up to shader
// model 5.1, pow of what may be negative (fxc X3571).
class ValueCheck {
 public:
  ValueCheck(const Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics) {}

  // Each checks a node that control reaches, not its operands.
  void Check(const Binary& node) { CheckOperator(node.op, node.right); }
  void Check(const Assign& node) {
    if (node.op) CheckOperator(*node.op, node.value);
  }
  void Check(const IntrinsicCall& node) {
    if (node.op == CommonIntrinsic::kPow) CheckPow(node);
  }

 private:
  // What is known of the sign of a value. A value whose parts are not looked into is kUnknown.
  enum class Sign : std::uint8_t { kNotNegative, kMayBeNegative, kUnknown };

  void CheckOperator(BinaryOp op, ExprId right) {
    if (op == BinaryOp::kDiv || op == BinaryOp::kMod) CheckDivision(op, right);
  }
  void CheckDivision(BinaryOp op, ExprId divisor);
  void CheckPow(const IntrinsicCall& call);
  Sign SignOf(ExprId expr);
  Sign SignOfVar(VarId id);
  Sign SignOfBinary(const Binary& node);
  Sign SignOfCall(const IntrinsicCall& call);
  void FindValues();

  const Program& program_;
  Diagnostics& diagnostics_;
  int steps_ = 0;  // of SignOf for one pow
  // By VarId, filled for the first pow of a variable: whether the variable is assigned to, and the
  // value that its declaration gives it.
  std::vector<bool> is_assigned_;
  std::vector<ExprId> declared_;
};

}  // namespace clipc::rules
