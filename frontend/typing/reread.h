// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/typing/conversion.h"
#include "ir/builder.h"

namespace clipc::typing {

// Whether the expression is a literal or a short path of variables, fields and simple indices:
// one that may be written again for every use.
bool IsPlainPath(const Program& program, ExprId expr);

// A value that is read several times: written out each time if it is a plain path, otherwise held
// in a temporary.
class Reread {
 public:
  Reread(Program& program, ExprId value, TemporaryMaker* temporaries);

  // Returns false if the value needs a temporary and `temporaries` is null.
  bool usable() const { return usable_; }
  TypeId type() const { return program_.exprs[value_].type; }
  // Returns a new expression for the value at each call.
  ExprId Read();
  // The expression that must be evaluated before the first Read(), or none.
  ExprId prologue() const { return prologue_; }
  // Returns `result`, an expression with uses of Read() in it, with the prologue before it.
  ExprId Finish(ExprId result);

 private:
  Program& program_;
  Builder builder_;
  ExprId value_;
  VarId temporary_;
  ExprId prologue_;
  bool usable_ = true;
};

}  // namespace clipc::typing
