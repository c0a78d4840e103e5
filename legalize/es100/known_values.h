// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "ir/program.h"
#include "legalize/es100/refused.h"

namespace clipc::legalize {

// A value of a variable that is known at one place of a function. The variable itself need not have
// it: assignments of known values are left out until something reads the variable.
struct Known {
  std::vector<std::uint64_t> bits;
  bool is_stored = false;  // whether the variable has the value
};
using Values = std::map<ir::VarId, Known>;

// The known values of the local variables and parameters of a function, while a walk goes through
// it in the order of execution, and the expressions with these values in them.
class KnownValues {
 public:
  // Of floats only the sources of refused parts are known.
  KnownValues(ir::Program& program, const Refused& refused)
      : program_(program), refused_(refused) {}

  Values now;
  // Called for each call of a function when its arguments are folded.
  std::function<void(ir::ExprId call)> on_call;

  // Whether the variable, a number or a vector, may have a known value.
  bool MayKnow(ir::VarId var) const;
  // Whether it is an array of whole numbers, whose elements may be known as long as the whole is.
  bool IsTable(ir::VarId var) const;

  // Folds `root` in place: reads of known variables become literals, and assignments of known
  // values their values. Appends the assignments that must come before it to `before`.
  void Fold(ir::ExprId root, std::vector<ir::StmtId>& before);
  // The same where nothing that `root` assigns to is known, before or after.
  void FoldUnknown(ir::ExprId root);

  // Makes the variable known where the value is, and unknown otherwise.
  void Assign(ir::VarId var, ir::ExprId value);
  void Forget(ir::VarId var) { now.erase(var); }
  // Appends the assignment of the known value if the variable does not have it.
  void Store(ir::VarId var, std::vector<ir::StmtId>& stmts);
  ir::StmtId StoreOf(ir::VarId var, const Known& known);

 private:
  bool FoldExpr(ir::ExprId expr);
  bool FoldOperands(ir::ExprId expr);
  void KeepInside(ir::Index node);
  bool FoldElement(ir::ExprId expr, ir::Index node);
  bool FoldAssign(ir::ExprId expr, ir::Assign node);
  bool FoldStep(ir::ExprId expr, ir::Unary node);
  bool FoldChoice(ir::ExprId expr, ir::Conditional node);
  bool FoldBoth(ir::ExprId expr, ir::Binary node);
  bool Become(ir::ExprId expr, ir::ExprId other);
  bool BecomeValue(ir::ExprId expr, std::span<const std::uint64_t> bits);
  void FindOpaque(ir::ExprId expr, bool is_conditional);
  ir::VarId Target(ir::ExprId target) const;

  ir::Program& program_;
  const Refused& refused_;
  std::vector<ir::VarId> opaque_;  // of the root that is folded: what it changes is not followed
};

}  // namespace clipc::legalize
