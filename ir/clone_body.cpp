// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/clone_body.h"

#include <utility>
#include <variant>
#include <vector>

#include "ir/builder.h"
#include "ir/walk.h"

namespace clipc::ir {

VarId BodyCloner::CloneVar(VarId var) {
  const VarId copy = program_.vars.Add(Var(program_.vars[var]));
  if (program_.vars[copy].init) program_.vars[copy].init = Clone(program_.vars[copy].init);
  vars_[var] = copy;
  return copy;
}

ExprId BodyCloner::Clone(ExprId expr) {
  const ExprId copy = ir::Clone(program_, expr);
  Rename(copy);
  return copy;
}

void BodyCloner::Rename(ExprId expr) {
  if (auto* ref = std::get_if<VarRef>(&program_.exprs[expr].node)) {
    if (const auto found = vars_.find(ref->var); found != vars_.end()) ref->var = found->second;
  }
  ForEachOperand(program_, expr, [&](ExprId operand) { Rename(operand); });
}

List<StmtId> BodyCloner::Clone(List<StmtId> list) {
  std::vector<StmtId> copies;
  for (std::uint32_t i = 0; i < list.size; ++i)
    copies.push_back(Clone(program_.stmt_lists[list][i]));
  return program_.stmt_lists.Add(copies);
}

StmtId BodyCloner::Clone(StmtId stmt) {
  Stmt copy = program_.stmts[stmt];
  const auto replace = [&](auto& part) { part = Clone(part); };
  ForEachPartSlot(copy, replace, replace, replace, [&](List<SwitchCase>& list) {
    std::vector<SwitchCase> cases;
    for (std::uint32_t i = 0; i < list.size; ++i) {
      SwitchCase arm = program_.switch_cases[list][i];
      std::vector<ExprId> labels;
      for (std::uint32_t l = 0; l < arm.labels.size; ++l)
        labels.push_back(Clone(program_.expr_lists[arm.labels][l]));
      arm.labels = program_.expr_lists.Add(labels);
      arm.body = Clone(arm.body);
      cases.push_back(arm);
    }
    list = program_.switch_cases.Add(cases);
  });
  if (auto* declare = std::get_if<Declare>(&copy.node)) declare->var = CloneVar(declare->var);
  return program_.stmts.Add(std::move(copy));
}

}  // namespace clipc::ir
