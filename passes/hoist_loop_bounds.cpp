// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/hoist_loop_bounds.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "ir/access.h"
#include "ir/builder.h"
#include "ir/walk.h"

namespace clipc::passes {

using namespace ir;

namespace {

class BoundHoisting {
 public:
  explicit BoundHoisting(Program& program) : program_(program) {}

  // Returns the statements of `list`, with the variables of its bounds before each loop.
  List<StmtId> Hoist(List<StmtId> list) {
    const auto stmts = program_.stmt_lists[list];
    if (std::ranges::none_of(stmts, [&](StmtId stmt) { return bool(ConditionOf(stmt)); }))
      return list;
    std::vector<StmtId> all;
    for (std::uint32_t i = 0; i < list.size; ++i) {
      const StmtId stmt = program_.stmt_lists[list][i];
      if (const ExprId condition = ConditionOf(stmt)) HoistFrom(condition, all);
      all.push_back(stmt);
    }
    return all.size() == list.size ? list : program_.stmt_lists.Add(std::span<const StmtId>(all));
  }

 private:
  ExprId ConditionOf(StmtId stmt) const {
    if (const auto* loop = As<For>(program_, stmt)) return loop->condition;
    if (const auto* loop = As<While>(program_, stmt)) return loop->condition;
    return {};
  }

  void HoistFrom(ExprId expr, std::vector<StmtId>& before) {
    if (!IsUniform(expr)) {
      for (const ExprId operand : OperandsOf(program_, expr)) HoistFrom(operand, before);
      return;
    }
    const std::string name = NameOf(expr);
    if (name.empty()) return;
    Builder b(program_, program_.exprs[expr].span);
    const VarId bound = b.Local(name, TypeIdOf(program_, expr));
    const ExprId value = b.Add(program_.exprs[expr].type, program_.exprs[expr].node);
    before.push_back(b.Stmt(Declare{bound, value}));
    program_.exprs[expr].node = VarRef{bound};
  }

  // Whether the expression has one value in the whole draw call, being made of uniforms and
  // literals alone.
  bool IsUniform(ExprId expr) const {
    return !AnyExpr(program_, expr, [&](ExprId part) {
      return !Visit(
          Overloaded{
              [&](const VarRef& node) {
                return program_.vars[node.var].storage == Storage::kUniform;
              },
              [&](const Index& node) { return As<Literal>(program_, node.index) != nullptr; },
              [](const Unary& node) { return !ChangesOperand(node.op); },
              [](const OneOf<Literal, FieldRef, Swizzle, Binary, Convert> auto&) { return true; },
              [](const auto&) { return false; },
          },
          program_.exprs[part].node);
    });
  }

  // The name of the uniform, or of the field of one, that the expression reads; empty if there is
  // none.
  std::string NameOf(ExprId expr) const {
    std::string name;
    AnyExpr(program_, expr, [&](ExprId part) {
      if (const auto* ref = As<VarRef>(program_, part)) name = program_.vars[ref->var].name;
      if (const auto* field = As<FieldRef>(program_, part))
        name = program_.types.StructOf(TypeIdOf(program_, field->base)).fields[field->field].name;
      return !name.empty();
    });
    return name;
  }

  Program& program_;
};

bool HasLoops(const Program& program) {
  for (const StmtId stmt : program.stmts.ids()) {
    if (As<For>(program, stmt) || As<While>(program, stmt)) return true;
  }
  return false;
}

}  // namespace

void HoistLoopBounds(Program& program) {
  if (!HasLoops(program)) return;
  BoundHoisting hoisting(program);
  std::vector<StmtId> lists;  // the statements that hold lists of statements
  for (const FunctionId id : program.functions.ids()) {
    lists.clear();
    ForEachStmt(program, program.functions[id].body, [&](StmtId stmt) {
      if (As<Block>(program, stmt) || As<Switch>(program, stmt)) lists.push_back(stmt);
    });
    for (const StmtId stmt : lists) {
      if (const auto* block = As<Block>(program, stmt)) {
        const List<StmtId> body = hoisting.Hoist(block->body);
        program.stmts[stmt].node = Block{body};
      }
      if (const auto* chosen = As<Switch>(program, stmt)) {
        const List<SwitchCase> cases = chosen->cases;
        for (std::uint32_t i = 0; i < cases.size; ++i) {
          const List<StmtId> body = hoisting.Hoist(program.switch_cases[cases][i].body);
          program.switch_cases[cases][i].body = body;
        }
      }
    }
  }
}

}  // namespace clipc::passes
