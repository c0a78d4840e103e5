// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/assign.h"

#include "frontend/check/expr.h"
#include "frontend/check/init.h"
#include "frontend/check/operator.h"
#include "frontend/check/value.h"

namespace clipc::check {
namespace {

// target = value, or target op= value.
ir::ExprId Assign(Context& context, const ast::AssignExpr& expr, ir::ExprId target,
                  ir::ExprId value, Span span) {
  if (!CheckTarget(context, target)) return context.ErrorExpr(span);
  if (expr.op) return AssignCompound(context, *expr.op, target, value, span);
  const ir::ExprId converted = Implicit(context, value, context.TypeIdOf(target));
  return context.IsError(converted) ? converted : StoreTo(context, target, converted, span);
}

// object[place] = value
ir::ExprId StoreElement(Context& context, ir::ExprId object, ir::ExprId place, ir::ExprId value,
                        Span span) {
  return context.At(span).Add(
      context.types.Void(),
      ir::ObjectCall{ir::ObjectOp::kStore, context.program.expr_lists.Add({object, place, value})});
}

// object[place] = value is a store; object[place].x = value and object[place] += value change a
// copy and store that.
ir::ExprId AssignElement(Context& context, const ast::AssignExpr& expr, ir::ExprId target,
                         ir::ExprId element, ir::ExprId value, Span span) {
  if (target == element && !expr.op) {
    const ir::ExprId converted = Implicit(context, value, context.TypeIdOf(target));
    if (context.IsError(converted)) return converted;
    const auto load = context[context.Get<ir::ObjectCall>(element).arguments];
    return StoreElement(context, load[0], load[1], converted, span);
  }
  Exprs steps;
  const ir::ExprId store = ChangeElement(context, element, steps);
  const ir::ExprId change = Assign(context, expr, target, value, span);
  if (context.IsError(change)) return change;
  steps.push_back(change);
  return WithPrologue(context, steps, store);
}

// m._m00_m11 = v  =>  (t = v, m[0][0] = t.x, m[1][1] = t.y, t)
ir::ExprId StoreToMatrixSwizzle(Context& context, ir::ExprId target, ir::ExprId value, Span span) {
  const auto node = context.Get<ir::MatrixSwizzle>(target);
  ir::Builder at = context.At(span);
  Exprs steps;
  const ir::ExprId base = Stabilize(context, node.base, steps);
  const ir::ExprId stored = Hoist(context, value, steps);
  for (int i = 0; i < node.count; ++i) {
    const ir::ExprId row = at.At(ir::Clone(context.program, base), std::uint32_t{node.rows[i]});
    const ir::ExprId component = at.At(row, std::uint32_t{node.columns[i]});
    steps.push_back(at.AssignTo(component, at.Swizzled(ir::Clone(context.program, stored), {i})));
  }
  return WithPrologue(context, steps, stored);
}

}  // namespace

void MarkConst(Context& context, ir::VarId var) {
  if (context.globals.const_vars.size() <= var.index)
    context.globals.const_vars.resize(var.index + 1);
  context.globals.const_vars[var.index] = true;
}

bool IsConstVar(const Context& context, ir::VarId var) {
  return var.index < context.globals.const_vars.size() && context.globals.const_vars[var.index];
}

bool CheckTarget(Context& context, ir::ExprId target) {
  const Span span = context[target].span;
  const ir::VarId root = ir::RootOf(context.program, target);
  if (!root) {
    context.Report(span, diag::NotAssignable);
    return false;
  }
  const ir::Var& var = context[root];
  if (var.storage == ir::Storage::kUniform) {
    context.Report(span, diag::UniformAssigned, var.name)
        .Note(var.span, diag::DeclaredHere, var.name);
    return false;
  }
  if (IsConstVar(context, root)) {
    context.Report(span, diag::ConstAssigned, var.name)
        .Note(var.span, diag::DeclaredHere, var.name);
    return false;
  }
  const auto& node = context[target].node;
  if (const auto* swizzle = std::get_if<ir::Swizzle>(&node)) {
    for (int i = 0; i < swizzle->count; ++i) {
      for (int j = 0; j < i; ++j) {
        if (swizzle->components[i] != swizzle->components[j]) continue;
        context.Report(span, diag::SwizzleRepeats);
        return false;
      }
    }
  }
  // v.yx[i], with an i known only at run time
  const auto* index = std::get_if<ir::Index>(&node);
  if (index && context.Is<ir::Swizzle>(index->base)) {
    context.Report(span, diag::Unsupported,
                   "assigning to a component of a swizzle chosen at run time");
    return false;
  }
  return true;
}

ir::ExprId ElementIn(const Context& context, ir::ExprId expr) {
  while (const ir::ExprId whole = ir::WholeOf(context.program, expr)) expr = whole;
  const auto* call = context.GetIf<ir::ObjectCall>(expr);
  if (!call) return {};
  const bool is_element = call->op == ir::ObjectOp::kBufferLoad ||
                          call->op == ir::ObjectOp::kStructuredLoad ||
                          call->op == ir::ObjectOp::kImageLoad;
  const ir::ExprId object = context[call->arguments][0];
  return is_element && ir::IsWritable(context.TypeOf(object).object) ? expr : ir::ExprId{};
}

ir::ExprId ChangeElement(Context& context, ir::ExprId element, Exprs& prologue) {
  const Span span = context[element].span;
  const auto load = context.Get<ir::ObjectCall>(element);
  const ir::ExprId object = context[load.arguments][0];
  ir::ExprId place = context[load.arguments][1];
  if (!ir::IsPure(context.program, place)) place = Hoist(context, place, prologue);
  const List<ir::ExprId> again = context.program.expr_lists.Add(
      {ir::Clone(context.program, object), ir::Clone(context.program, place)});
  const ir::ExprId read =
      context.At(span).Add(context.TypeIdOf(element), ir::ObjectCall{load.op, again});
  const ir::ExprId copy = Hoist(context, read, prologue);
  context[element].node = context[copy].node;
  return StoreElement(context, object, place, copy, span);
}

ir::ExprId Stabilize(Context& context, ir::ExprId path, Exprs& prologue) {
  if (ir::IsPure(context.program, path)) return path;
  auto& node = context[path].node;
  if (auto* index = std::get_if<ir::Index>(&node)) {
    const ir::ExprId base = Stabilize(context, index->base, prologue);
    const ir::ExprId number = ir::IsPure(context.program, index->index)
                                  ? index->index
                                  : Hoist(context, index->index, prologue);
    context[path].node = ir::Index{base, number};
  } else if (auto* field = std::get_if<ir::FieldRef>(&node)) {
    field->base = Stabilize(context, field->base, prologue);
  } else if (auto* swizzle = std::get_if<ir::Swizzle>(&node)) {
    swizzle->base = Stabilize(context, swizzle->base, prologue);
  } else if (auto* matrix = std::get_if<ir::MatrixSwizzle>(&node)) {
    matrix->base = Stabilize(context, matrix->base, prologue);
  }
  return path;
}

ir::ExprId CheckAssign(Context& context, const ast::AssignExpr& expr, Span span) {
  const ir::ExprId target = CheckExpr(context, expr.left);
  const bool is_list = context.Is<ast::InitListExpr>(expr.right);
  if (is_list && !expr.op && !context.IsError(target)) {
    const ir::ExprId value = CheckInit(context, expr.right, context.TypeIdOf(target));
    return !context.IsError(value) && CheckTarget(context, target)
               ? StoreTo(context, target, value, span)
               : context.ErrorExpr(span);
  }
  const ir::ExprId value = CheckExpr(context, expr.right);
  if (context.IsError(target, value)) return context.ErrorExpr(span);
  if (const ir::ExprId element = ElementIn(context, target))
    return AssignElement(context, expr, target, element, value, span);
  return Assign(context, expr, target, value, span);
}

ir::ExprId AssignCompound(Context& context, ast::BinaryOp op, ir::ExprId target, ir::ExprId value,
                          Span span) {
  const ir::TypeId type_id = context.TypeIdOf(target);
  const ir::Type type = context[type_id];
  if (type.IsNumeric() && type.Components() == 1 && context.TypeOf(value).Components() > 1) {
    value =
        Implicit(context, value, context.types.WithScalar(type_id, context.TypeOf(value).scalar));
  }
  const bool is_numeric = type.IsNumeric() && context.TypeOf(value).IsNumeric();
  const auto common = is_numeric ? OperandType(context, op, target, value, span) : std::nullopt;
  if (is_numeric && !common) return context.ErrorExpr(span);
  const bool is_swizzle = context.Is<ir::MatrixSwizzle>(target);
  if (common && !is_swizzle) {
    const bool is_shift = op == ast::BinaryOp::kShiftLeft || op == ast::BinaryOp::kShiftRight;
    const ir::TypeId same_shape = context.types.WithScalar(*common, type.scalar);
    const bool same_kind = ir::BaseOf(context[*common].scalar) == ir::BaseOf(type.scalar);
    if (same_shape == type_id && type.scalar != ir::Scalar::kBool && (same_kind || is_shift)) {
      const ir::Scalar kind = is_shift && context.TypeOf(value).scalar != ir::Scalar::kBool
                                  ? context.TypeOf(value).scalar
                                  : type.scalar;
      value = Implicit(context, value, context.types.WithScalar(type_id, kind));
      return context.IsError(value)
                 ? value
                 : context.At(span).AssignTo(target, value, static_cast<ir::BinaryOp>(op));
    }
  }
  Exprs prologue;
  target = Stabilize(context, target, prologue);
  const bool is_bool = type.IsNumeric() && type.scalar == ir::Scalar::kBool;
  if (is_bool && op == ast::BinaryOp::kBitAnd) op = ast::BinaryOp::kLogicalAnd;
  if (is_bool && op == ast::BinaryOp::kBitOr) op = ast::BinaryOp::kLogicalOr;
  const ir::ExprId result =
      CombineOperands(context, op, ir::Clone(context.program, target), value, span, span);
  if (context.IsError(result)) return result;
  const ir::ExprId converted = Implicit(context, result, type_id);
  return context.IsError(converted)
             ? converted
             : WithPrologue(context, prologue, StoreTo(context, target, converted, span));
}

ir::ExprId StoreTo(Context& context, ir::ExprId target, ir::ExprId value, Span span) {
  if (context.Is<ir::MatrixSwizzle>(target)) {
    return StoreToMatrixSwizzle(context, target, value, span);
  }
  return context.At(span).AssignTo(target, value);
}

}  // namespace clipc::check
