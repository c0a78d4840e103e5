// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/check/checker.h"

// Assignment, and what may be assigned to.
namespace clipc {

void Checker::MarkConst(ir::VarId var) {
  if (const_vars_.size() <= var.index) const_vars_.resize(var.index + 1);
  const_vars_[var.index] = true;
}

bool Checker::IsConstVar(ir::VarId var) const {
  return var.index < const_vars_.size() && const_vars_[var.index];
}

bool Checker::IsPath(ir::ExprId expr) const {
  return static_cast<bool>(ir::RootOf(program_, expr));
}

// Whether the expression can be assigned to; reports why not.
bool Checker::CheckTarget(ir::ExprId target) {
  const Span span = program_.exprs[target].span;
  const ir::VarId root = ir::RootOf(program_, target);
  if (!root) {
    diagnostics_.Report(span, diag::NotAssignable);
    return false;
  }
  const ir::Var& var = program_.vars[root];
  if (var.storage == ir::Storage::kUniform) {
    diagnostics_.Report(span, diag::UniformAssigned, var.name)
        .Note(var.span, diag::DeclaredHere, var.name);
    return false;
  }
  if (IsConstVar(root)) {
    diagnostics_.Report(span, diag::ConstAssigned, var.name)
        .Note(var.span, diag::DeclaredHere, var.name);
    return false;
  }
  const auto& node = program_.exprs[target].node;
  if (const auto* swizzle = std::get_if<ir::Swizzle>(&node)) {
    for (int i = 0; i < swizzle->count; ++i) {
      for (int j = 0; j < i; ++j) {
        if (swizzle->components[i] != swizzle->components[j]) continue;
        diagnostics_.Report(span, diag::SwizzleRepeats);
        return false;
      }
    }
  }
  // v.yx[i], with an i known only at run time
  const auto* index = std::get_if<ir::Index>(&node);
  if (index && std::holds_alternative<ir::Swizzle>(program_.exprs[index->base].node)) {
    diagnostics_.Report(span, diag::Unsupported,
                        "assigning to a component of a swizzle chosen at run time");
    return false;
  }
  return true;
}

// The read of a writable object that a path of fields, indices and swizzles starts at, `buffer[i]`
// in `buffer[i].x`; none for other expressions.
ir::ExprId Checker::ElementIn(ir::ExprId expr) const {
  while (const ir::ExprId whole = ir::WholeOf(program_, expr)) expr = whole;
  const auto* call = ir::As<ir::ObjectCall>(program_, expr);
  if (!call) return {};
  const bool is_element = call->op == ir::ObjectOp::kBufferLoad ||
                          call->op == ir::ObjectOp::kStructuredLoad ||
                          call->op == ir::ObjectOp::kImageLoad;
  const ir::ExprId object = program_.expr_lists[call->arguments][0];
  return is_element && ir::IsWritable(TypeOf(object).object) ? expr : ir::ExprId{};
}

// object[place] = value is a store; object[place].x = value and object[place] += value change a
// copy and store that.
ir::ExprId Checker::AssignElement(const ast::AssignExpr& expr, ir::ExprId target,
                                  ir::ExprId element, ir::ExprId value, Span span) {
  if (target == element && !expr.op) {
    const ir::ExprId converted = Implicit(value, TypeIdOf(target));
    if (IsError(converted)) return converted;
    const auto& load = std::get<ir::ObjectCall>(program_.exprs[element].node);
    const ir::ExprId arguments[] = {program_.expr_lists[load.arguments][0],
                                    program_.expr_lists[load.arguments][1], converted};
    return At(span).Add(program_.types.Void(),
                        ir::ObjectCall{ir::ObjectOp::kStore, program_.expr_lists.Add(arguments)});
  }
  std::vector<ir::ExprId> steps;
  const ir::ExprId store = ChangeElement(element, steps);
  if (!CheckTarget(target)) return ErrorExpr(span);
  ir::ExprId change;
  if (expr.op) {
    change = AssignCompound(*expr.op, target, value, span, span);
  } else {
    const ir::ExprId converted = Implicit(value, TypeIdOf(target));
    change = IsError(converted) ? converted : StoreTo(target, converted, span);
  }
  if (IsError(change)) return change;
  steps.push_back(change);
  return WithPrologue(steps, store);
}

// Makes the read a variable that holds what was read, in place; the result stores the variable.
ir::ExprId Checker::ChangeElement(ir::ExprId element, std::vector<ir::ExprId>& prologue) {
  const Span span = program_.exprs[element].span;
  const auto load = std::get<ir::ObjectCall>(program_.exprs[element].node);
  const ir::ExprId object = program_.expr_lists[load.arguments][0];
  ir::ExprId place = program_.expr_lists[load.arguments][1];
  if (!ir::IsPure(program_, place)) place = Hoist(place, prologue);
  const ir::ExprId again[] = {ir::Clone(program_, object), ir::Clone(program_, place)};
  const ir::ExprId read =
      At(span).Add(TypeIdOf(element), ir::ObjectCall{load.op, program_.expr_lists.Add(again)});
  const ir::ExprId copy = Hoist(read, prologue);
  program_.exprs[element].node = program_.exprs[copy].node;
  const ir::ExprId arguments[] = {object, place, copy};
  return At(span).Add(program_.types.Void(),
                      ir::ObjectCall{ir::ObjectOp::kStore, program_.expr_lists.Add(arguments)});
}

// The path with every index that does something replaced by a temporary, so that it can be cloned.
ir::ExprId Checker::Stabilize(ir::ExprId path, std::vector<ir::ExprId>& prologue) {
  if (ir::IsPure(program_, path)) return path;
  auto& node = program_.exprs[path].node;
  if (auto* index = std::get_if<ir::Index>(&node)) {
    const ir::ExprId base = Stabilize(index->base, prologue);
    const ir::ExprId number =
        ir::IsPure(program_, index->index) ? index->index : Hoist(index->index, prologue);
    program_.exprs[path].node = ir::Index{base, number};
  } else if (auto* field = std::get_if<ir::FieldRef>(&node)) {
    field->base = Stabilize(field->base, prologue);
  } else if (auto* swizzle = std::get_if<ir::Swizzle>(&node)) {
    swizzle->base = Stabilize(swizzle->base, prologue);
  } else if (auto* matrix = std::get_if<ir::MatrixSwizzle>(&node)) {
    matrix->base = Stabilize(matrix->base, prologue);
  }
  return path;
}

ir::ExprId Checker::CheckAssign(const ast::AssignExpr& expr, Span span) {
  const ir::ExprId target = CheckExpr(expr.left);
  const bool is_list = std::holds_alternative<ast::InitListExpr>(file_.exprs[expr.right].node);
  if (is_list && !expr.op && !IsError(target)) {
    const ir::ExprId value = CheckInit(expr.right, TypeIdOf(target));
    return !IsError(value) && CheckTarget(target) ? StoreTo(target, value, span) : ErrorExpr(span);
  }
  const ir::ExprId value = CheckExpr(expr.right);
  if (IsError(target) || IsError(value)) return ErrorExpr(span);
  if (const ir::ExprId element = ElementIn(target))
    return AssignElement(expr, target, element, value, span);
  if (!CheckTarget(target)) return ErrorExpr(span);
  if (expr.op) return AssignCompound(*expr.op, target, value, span, span);
  const ir::ExprId converted = Implicit(value, TypeIdOf(target));
  return IsError(converted) ? converted : StoreTo(target, converted, span);
}

// target op= value. Where the operator works on another type than the target's: target = (T)(target
// op value).
ir::ExprId Checker::AssignCompound(ast::BinaryOp op, ir::ExprId target, ir::ExprId value,
                                   Span op_span, Span span) {
  const ir::TypeId type_id = TypeIdOf(target);
  const ir::Type type = program_.types[type_id];
  if (type.IsNumeric() && type.Components() == 1 && TypeOf(value).Components() > 1) {
    value = Implicit(value, program_.types.WithScalar(type_id, TypeOf(value).scalar));
  }
  const bool is_numeric = type.IsNumeric() && TypeOf(value).IsNumeric();
  const auto common = is_numeric ? OperandType(op, target, value, op_span) : std::nullopt;
  if (is_numeric && !common) return ErrorExpr(span);
  const bool is_swizzle = std::holds_alternative<ir::MatrixSwizzle>(program_.exprs[target].node);
  if (common && !is_swizzle) {
    const bool is_shift = op == ast::BinaryOp::kShiftLeft || op == ast::BinaryOp::kShiftRight;
    const ir::TypeId same_shape = program_.types.WithScalar(*common, type.scalar);
    const bool same_kind = ir::BaseOf(program_.types[*common].scalar) == ir::BaseOf(type.scalar);
    if (same_shape == type_id && type.scalar != ir::Scalar::kBool && (same_kind || is_shift)) {
      const ir::Scalar kind = is_shift && TypeOf(value).scalar != ir::Scalar::kBool
                                  ? TypeOf(value).scalar
                                  : type.scalar;
      value = Implicit(value, program_.types.WithScalar(type_id, kind));
      return IsError(value) ? value
                            : At(span).AssignTo(target, value, static_cast<ir::BinaryOp>(op));
    }
  }
  std::vector<ir::ExprId> prologue;
  target = Stabilize(target, prologue);
  const bool is_bool = type.IsNumeric() && type.scalar == ir::Scalar::kBool;
  if (is_bool && op == ast::BinaryOp::kBitAnd) op = ast::BinaryOp::kLogicalAnd;
  if (is_bool && op == ast::BinaryOp::kBitOr) op = ast::BinaryOp::kLogicalOr;
  const ir::ExprId result = CombineOperands(op, ir::Clone(program_, target), value, op_span, span);
  if (IsError(result)) return result;
  const ir::ExprId converted = Implicit(result, type_id);
  return IsError(converted) ? converted : WithPrologue(prologue, StoreTo(target, converted, span));
}

// target = value, both of one type.
ir::ExprId Checker::StoreTo(ir::ExprId target, ir::ExprId value, Span span) {
  if (std::holds_alternative<ir::MatrixSwizzle>(program_.exprs[target].node)) {
    return StoreToMatrixSwizzle(target, value, span);
  }
  return At(span).AssignTo(target, value);
}

// m._m00_m11 = v  =>  (t = v, m[0][0] = t.x, m[1][1] = t.y, t)
ir::ExprId Checker::StoreToMatrixSwizzle(ir::ExprId target, ir::ExprId value, Span span) {
  const auto node = std::get<ir::MatrixSwizzle>(program_.exprs[target].node);
  ir::Builder at = At(span);
  std::vector<ir::ExprId> steps;
  const ir::ExprId base = Stabilize(node.base, steps);
  const ir::ExprId stored = Hoist(value, steps);
  for (int i = 0; i < node.count; ++i) {
    const ir::ExprId row = at.At(ir::Clone(program_, base), std::uint32_t{node.rows[i]});
    const ir::ExprId component = at.At(row, std::uint32_t{node.columns[i]});
    steps.push_back(at.AssignTo(component, at.Swizzled(ir::Clone(program_, stored), {i})));
  }
  return WithPrologue(steps, stored);
}

}  // namespace clipc
