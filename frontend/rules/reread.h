// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/conversion.h"
#include "ir/builder.h"

namespace clipc {

// Whether the expression is a literal or a short path of variables, fields and simple indices:
// one that may be written again for every use.
bool IsPlainPath(const ir::Program& program, ir::ExprId expr);

// A value that is read several times: written out each time when it is a plain path, else held in a
// temporary.
class Reread {
 public:
  Reread(ir::Program& program, ir::ExprId value, TemporaryMaker* temporaries);

  // False when the value needs a temporary and `temporaries` is null.
  bool usable() const { return usable_; }
  ir::TypeId type() const { return program_.exprs[value_].type; }
  // A fresh expression each time.
  ir::ExprId Read();
  // The expression that must be evaluated before the first Read(), or none.
  ir::ExprId prologue() const { return prologue_; }
  // `result`, an expression with uses of Read() in it, after the prologue.
  ir::ExprId Finish(ir::ExprId result);

 private:
  ir::Program& program_;
  ir::Builder builder_;
  ir::ExprId value_;
  ir::VarId temporary_;
  ir::ExprId prologue_;
  bool usable_ = true;
};

}  // namespace clipc
