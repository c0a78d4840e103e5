// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/es100/loops.h"

#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::legalize {

using namespace ir;

namespace {

bool IsConstant(const Program& program, ExprId expr) { return IsConstantIndex(program, expr, {}); }

}  // namespace

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
    if (!As<For>(program, stmt) || !WhyNotAlone(program, stmt, loop).empty() || loop.is_declared)
      return;
    uses[loop.counter.index] = 0;
    count(stmt, uses);
    uses_in_loops_[loop.counter.index] += uses[loop.counter.index];
  });
}

std::string_view CountedLoops::WhyNot(StmtId stmt, CountedLoop& loop) const {
  const std::string_view why = WhyNotAlone(program_, stmt, loop);
  if (!why.empty() || !loop.counter || loop.is_declared) return why;
  const std::uint32_t index = loop.counter.index;
  const bool is_local = program_.vars[loop.counter].storage == Storage::kLocal;
  return is_local && uses_[index] == uses_in_loops_[index]
             ? ""
             : "has an index that is used outside of it";
}

std::string_view WhyNotAlone(const Program& program, StmtId stmt, CountedLoop& loop) {
  if (As<While>(program, stmt)) return "is a `while`";
  if (As<DoWhile>(program, stmt)) return "is a `do`";
  const auto* node = As<For>(program, stmt);
  if (!node) return "";
  loop = PartsOf(program, *node);
  if (!loop.counter) return "does not begin with a value of its index";
  if (!loop.start || !IsConstant(program, loop.start)) return "does not begin at a constant";
  if (!node->condition) return "has no condition";
  const auto* compare = As<Binary>(program, loop.comparison);
  if (!compare || !IsConstant(program, compare->right)) return "does not end at a constant";
  if (loop.more && !IsPure(program, loop.more)) return "has a condition that changes something";
  if (!loop.step || (loop.step_size && !IsConstant(program, loop.step_size)))
    return "does not step by a constant";
  if (IsChangedInBody(program, *node, loop.counter)) return "changes its index";
  return "";
}

bool IsConstantIndex(const Program& program, ExprId expr, std::span<const char> loop_indices) {
  const auto is_constant = [&](ExprId part) {
    return IsConstantIndex(program, part, loop_indices);
  };
  if (As<Literal>(program, expr) || As<Zero>(program, expr)) return true;
  if (const auto* convert = As<Convert>(program, expr)) return is_constant(convert->operand);
  if (const auto* unary = As<Unary>(program, expr))
    return unary->op == UnaryOp::kNegate && is_constant(unary->operand);
  if (const auto* binary = As<Binary>(program, expr)) {
    const bool is_sum = binary->op == BinaryOp::kAdd || binary->op == BinaryOp::kSub ||
                        binary->op == BinaryOp::kMul || binary->op == BinaryOp::kDiv;
    return is_sum && is_constant(binary->left) && is_constant(binary->right);
  }
  const auto* ref = As<VarRef>(program, expr);
  if (!ref) return false;
  const Var& var = program.vars[ref->var];
  if (var.storage == Storage::kConstant) return var.init && is_constant(var.init);
  return ref->var.index < loop_indices.size() && loop_indices[ref->var.index] != 0;
}

}  // namespace clipc::legalize
