// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>

#include "ir/program.h"

namespace clipc::ir {

// A copier of statements with everything in them; the copies have variables of their own.
class BodyCloner {
 public:
  explicit BodyCloner(Program& program) : program_(program) {}
  VarId CloneVar(VarId var);
  StmtId Clone(StmtId stmt);
  // The copies of variables, by the original.
  const std::map<VarId, VarId>& vars() const { return vars_; }

 private:
  ExprId Clone(ExprId expr);
  List<StmtId> Clone(List<StmtId> list);
  void Rename(ExprId expr);

  Program& program_;
  std::map<VarId, VarId> vars_;
};

}  // namespace clipc::ir
