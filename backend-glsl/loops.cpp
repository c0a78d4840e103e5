// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/loops.h"

#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::glsl {

using namespace ir;

CountedLoops::CountedLoops(const Program& program, StmtId body)
    : program_(program), uses_(program.vars.size()), uses_in_loops_(program.vars.size()) {
  const auto count = [&](auto root, std::vector<std::uint32_t>& uses) {
    ForEachExpr(program, root, [&](ExprId expr) {
      if (const auto* ref = As<VarRef>(program, expr)) ++uses[ref->var.index];
    });
  };
  count(body, uses_);
  std::vector<std::uint32_t> uses(program.vars.size());
  ForEachStmt(program, body, [&](StmtId stmt) {
    CountedLoop loop;
    if (!As<For>(program, stmt) || !WhyNotAlone(stmt, loop).empty() || loop.is_declared) return;
    uses[loop.index.index] = 0;
    count(stmt, uses);
    uses_in_loops_[loop.index.index] += uses[loop.index.index];
  });
}

std::string_view CountedLoops::WhyNot(StmtId stmt, CountedLoop& loop) const {
  const std::string_view why = WhyNotAlone(stmt, loop);
  if (!why.empty() || loop.is_declared) return why;
  const std::uint32_t index = loop.index.index;
  const bool is_local = program_.vars[loop.index].storage == Storage::kLocal;
  return is_local && uses_[index] == uses_in_loops_[index]
             ? ""
             : "has an index that is used outside of it";
}

std::string_view CountedLoops::WhyNotAlone(StmtId stmt, CountedLoop& loop) const {
  if (As<While>(program_, stmt)) return "is a `while`";
  if (As<DoWhile>(program_, stmt)) return "is a `do`";
  const auto* node = As<For>(program_, stmt);
  if (!node) return "";
  const auto init = program_.stmt_lists[node->init];
  for (const StmtId each : init) {
    const auto* declare = As<Declare>(program_, each);
    const auto* evaluate = As<Evaluate>(program_, each);
    const auto* assign = evaluate ? As<Assign>(program_, evaluate->expr) : nullptr;
    const auto* target = assign && !assign->op ? As<VarRef>(program_, assign->target) : nullptr;
    if (!declare && !target) return "does not begin with a value of its index";
    const VarId index = declare ? declare->var : target->var;
    if (loop.index && !IsBound(node->condition, index)) continue;
    loop.index = index;
    loop.start = declare ? declare->init : assign->value;
    loop.is_declared = declare != nullptr;
  }
  if (!loop.index) return "does not begin with a value of its index";
  if (!loop.start || !IsConstant(loop.start)) return "does not begin at a constant";
  if (!node->condition) return "has no condition";
  loop.bound = node->condition;
  if (const auto* both = As<Binary>(program_, node->condition);
      both && (both->op == BinaryOp::kLogicalAnd || both->op == BinaryOp::kShortCircuitAnd)) {
    const bool is_left = IsBound(both->left, loop.index);
    loop.bound = is_left ? both->left : both->right;
    loop.more = is_left ? both->right : both->left;
    if (!IsPure(program_, loop.more)) return "has a condition that changes something";
  }
  if (!IsBound(loop.bound, loop.index)) return "does not end at a constant";
  if (!node->step || !IsStep(node->step, loop.index)) return "does not step by a constant";
  const StmtId body[] = {node->body};
  if (AssignedIn(program_, body)[loop.index.index]) return "changes its index";
  return "";
}

bool CountedLoops::IsIndex(ExprId expr, VarId index) const {
  if (const auto* convert = As<Convert>(program_, expr)) {
    const auto is_whole = [&](ExprId id) { return IsInteger(TypeOf(program_, id).scalar); };
    if (is_whole(expr) && is_whole(convert->operand)) expr = convert->operand;
  }
  const auto* ref = As<VarRef>(program_, expr);
  const Type& type = TypeOf(program_, expr);
  return ref && ref->var == index && type.kind == TypeKind::kScalar &&
         BaseOf(type.scalar) != Scalar::kBool;
}

bool CountedLoops::IsConstant(ExprId expr) const {
  if (As<Literal>(program_, expr) || As<Zero>(program_, expr)) return true;
  if (const auto* convert = As<Convert>(program_, expr)) return IsConstant(convert->operand);
  if (const auto* unary = As<Unary>(program_, expr))
    return unary->op == UnaryOp::kNegate && IsConstant(unary->operand);
  if (const auto* binary = As<Binary>(program_, expr)) {
    const bool is_sum = binary->op == BinaryOp::kAdd || binary->op == BinaryOp::kSub ||
                        binary->op == BinaryOp::kMul || binary->op == BinaryOp::kDiv;
    return is_sum && IsConstant(binary->left) && IsConstant(binary->right);
  }
  const auto* ref = As<VarRef>(program_, expr);
  return ref && program_.vars[ref->var].storage == Storage::kConstant &&
         program_.vars[ref->var].init && IsConstant(program_.vars[ref->var].init);
}

bool CountedLoops::IsBound(ExprId condition, VarId index) const {
  const auto* compare = As<Binary>(program_, condition);
  return compare && IsComparison(compare->op) && IsIndex(compare->left, index) &&
         IsConstant(compare->right);
}

bool CountedLoops::IsStep(ExprId step, VarId index) const {
  if (const auto* unary = As<Unary>(program_, step))
    return ChangesOperand(unary->op) && IsIndex(unary->operand, index);
  const auto* assign = As<Assign>(program_, step);
  return assign && (assign->op == BinaryOp::kAdd || assign->op == BinaryOp::kSub) &&
         IsIndex(assign->target, index) && IsConstant(assign->value);
}

}  // namespace clipc::glsl
