// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "ir/program.h"
#include "ir/walk.h"

namespace clipc::glsl {

// What `main` reaches, and so what is written.
struct Reached {
  std::vector<ir::FunctionId> functions;  // callees before callers, `main` last
  std::vector<ir::VarId> globals;         // kStatic and kConstant, in order of declaration
  std::vector<bool> vars;                 // by VarId: mentioned anywhere
  std::vector<bool> cbuffers;             // by CbufferId

  bool Has(ir::VarId var) const { return vars[var.index]; }
  bool Has(ir::CbufferId cbuffer) const { return cbuffers[cbuffer.index]; }
};
Reached Reach(const ir::Program& program);

// Calls visit(ExprId) for every expression at and below `expr`, parents before operands, in order
// of the text.
template <typename Visit>
void ForEachExpr(const ir::Program& program, ir::ExprId expr, Visit&& visit) {
  visit(expr);
  ir::ForEachOperand(program, expr,
                     [&](ir::ExprId operand) { ForEachExpr(program, operand, visit); });
}

// The same for every expression in a statement.
template <typename Visit>
void ForEachExpr(const ir::Program& program, ir::StmtId stmt, Visit&& visit) {
  ir::ForEachPart(
      program, stmt, [&](ir::ExprId expr) { ForEachExpr(program, expr, visit); },
      [&](ir::StmtId part) { ForEachExpr(program, part, visit); });
}

}  // namespace clipc::glsl
