// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <span>
#include <variant>
#include <vector>

#include "ir/walk.h"
#include "legalize/es100/loops.h"
#include "legalize/es100/lower_to_es100.h"

namespace clipc::legalize {

using namespace ir;

namespace {

class LoopLowering {
 public:
  explicit LoopLowering(Program& program) : program_(program) {}

  void Lower(StmtId stmt, const CountedLoop& loop) {
    For node = *As<For>(program_, stmt);
    const auto listed = program_.stmt_lists[node.init];
    std::vector<StmtId> around(listed.begin(), listed.end());
    Builder b(program_, program_.stmts[stmt].span);
    VarId index = loop.counter;
    if (!loop.is_declared) {
      index = b.Local(program_.vars[index].name, program_.vars[index].type);
      Rename(stmt, loop.counter, index);
    }
    // The other variables of the head are declared before the loop.
    std::erase_if(around, [&](StmtId each) {
      const auto* declare = As<Declare>(program_, each);
      return loop.is_declared ? declare->var == index : !declare;
    });
    const StmtId head[] = {b.Stmt(Declare{index, loop.start})};
    node.init = program_.stmt_lists.Add(std::span<const StmtId>(head));
    node.condition = loop.comparison;
    if (loop.more) node.body = Checked(b, loop.more, node.body);
    MakePostfix(node.step);
    if (around.empty()) {
      program_.stmts[stmt].node = node;
      return;
    }
    around.push_back(b.Stmt(node));
    program_.stmts[around.back()].hint = program_.stmts[stmt].hint;
    program_.stmts[stmt].node = Block{program_.stmt_lists.Add(std::span<const StmtId>(around))};
  }

 private:
  // { if (!more) break; .. }
  StmtId Checked(Builder b, ExprId more, StmtId body) {
    std::vector<StmtId> all = {b.Stmt(If{b.UnaryOf(UnaryOp::kNot, more), b.Stmt(Break{}), {}})};
    if (const auto* block = As<Block>(program_, body)) {
      const auto listed = program_.stmt_lists[block->body];
      all.insert(all.end(), listed.begin(), listed.end());
    } else {
      all.push_back(body);
    }
    return b.BlockOf(all);
  }

  // Makes the step a postfix operator; its value is not read.
  void MakePostfix(ExprId step) {
    auto* unary = std::get_if<Unary>(&program_.exprs[step].node);
    if (!unary) return;
    if (unary->op == UnaryOp::kPreIncrement) unary->op = UnaryOp::kPostIncrement;
    if (unary->op == UnaryOp::kPreDecrement) unary->op = UnaryOp::kPostDecrement;
  }

  void Rename(StmtId stmt, VarId from, VarId to) {
    ForEachExpr(program_, stmt, [&](ExprId expr) {
      const auto* ref = As<VarRef>(program_, expr);
      if (ref && ref->var == from) program_.exprs[expr].node = VarRef{to};
    });
  }

  Program& program_;
};

}  // namespace

void LowerLoops(Legalizer& legalizer) {
  if (!legalizer.needs.constant_loops) return;
  Program& program = legalizer.program;
  struct Found {
    StmtId stmt;
    CountedLoop loop;
  };
  std::vector<Found> all;
  for (const FunctionId id : program.functions.ids()) {
    const StmtId body = program.functions[id].body;
    const CountedLoops loops(program, body);
    ForEachStmt(program, body, [&](StmtId stmt) {
      const auto* node = As<For>(program, stmt);
      CountedLoop loop;
      if (node && loops.WhyNot(stmt, loop).empty()) all.push_back({stmt, loop});
    });
  }
  for (const Found& found : all) LoopLowering(program).Lower(found.stmt, found.loop);
}

}  // namespace clipc::legalize
