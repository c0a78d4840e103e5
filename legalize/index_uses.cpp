// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/index_uses.h"

#include "base/overloaded.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::legalize {

using namespace ir;

namespace {

bool IsInteger(const Program& program, ExprId expr) {
  const Type& type = TypeOf(program, expr);
  return type.IsNumeric() && ir::IsInteger(type.scalar);
}

// Whether an index beyond all arrays stays beyond them: a `&`, `%` or shift may bring it back.
bool KeepsSize(BinaryOp op) {
  return op == BinaryOp::kAdd || op == BinaryOp::kSub || op == BinaryOp::kMul;
}

}  // namespace

IndexUses::IndexUses(const Program& program)
    : program_(program),
      is_index_(program.exprs.size()),
      uses_(program.vars.size()),
      values_(program.vars.size()) {
  const std::vector<ExprId> places = FindUses();
  for (const VarId var : program.vars.ids()) {
    if (uses_[var.index] == 0) waiting_.push_back(var);
  }
  for (const ExprId place : places) Mark(place);
  while (!waiting_.empty()) {
    const VarId var = waiting_.back();
    waiting_.pop_back();
    for (const ExprId value : values_[var.index]) Mark(value);
  }
}

void IndexUses::Mark(ExprId expr) {
  if (is_index_[expr.index] || !IsInteger(program_, expr)) return;
  is_index_[expr.index] = true;
  Visit(Overloaded{
            [&](const VarRef& node) { Drop(node.var); },
            [&](const OneOf<Index, Swizzle> auto& node) { Mark(node.base); },
            [&](const OneOf<Convert, Splat> auto& node) { Mark(node.operand); },
            [&](const Binary& node) {
              if (KeepsSize(node.op)) Mark(node.left), Mark(node.right);
            },
            [&](const IntrinsicCall& node) {
              if (node.op == CommonIntrinsic::kNonUniform)
                Mark(program_.expr_lists[node.arguments][0]);
            },
            [&](const Construct& node) {
              for (const ExprId part : program_.expr_lists[node.arguments]) Mark(part);
            },
            [](const auto&) {},
        },
        program_.exprs[expr].node);
}

std::vector<ExprId> IndexUses::FindUses() {
  std::vector<ExprId> places;
  for (const FunctionId id : program_.functions.ids()) {
    ForEachStmt(program_, program_.functions[id].body, [&](StmtId stmt) {
      const auto* declare = As<Declare>(program_, stmt);
      if (declare && declare->init) AddValue(declare->var, declare->init);
    });
  }
  const auto read = Overloaded{
      [&](const VarRef& node) { ++uses_[node.var.index]; },
      [&](const Index& node) { places.push_back(node.index); },
      [&](const Assign& node) {
        const auto* target = As<VarRef>(program_, node.target);
        if (!target || node.op) return;
        --uses_[target->var.index];  // where this is first, the target's own visit makes it 0 again
        AddValue(target->var, node.value);
      },
      [&](const Call& node) {
        const auto arguments = program_.expr_lists[node.arguments];
        const auto& parameters = program_.functions[node.function].parameters;
        for (std::size_t i = 0; i < arguments.size(); ++i) AddValue(parameters[i], arguments[i]);
      },
      [&](const ObjectCall& node) {
        if (!LoadsElement(node.op)) return;
        places.push_back(OperandOf(program_, node, OperandKind::kPlace));
        if (const ExprId level = OperandOf(program_, node, OperandKind::kLevel))
          places.push_back(level);
      },
      [](const auto&) {},
  };
  ForEachLiveExpr(program_, [&](ExprId expr) { Visit(read, program_.exprs[expr].node); });
  return places;
}

void IndexUses::AddValue(VarId var, ExprId value) {
  const Storage storage = program_.vars[var].storage;
  if (storage == Storage::kLocal || storage == Storage::kIn) values_[var.index].push_back(value);
}

void IndexUses::Drop(VarId var) {
  if (--uses_[var.index] == 0) waiting_.push_back(var);
}

}  // namespace clipc::legalize
