// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/index.h"

#include "frontend/check/construct.h"
#include "frontend/check/expr.h"
#include "frontend/check/member.h"
#include "frontend/check/operator.h"
#include "frontend/check/value.h"
#include "frontend/rules/constant.h"
#include "frontend/rules/objects.h"

namespace clipc::check {
namespace {

// texture.mips[level][position]; none when the expression is something else.
ir::ExprId CheckMips(Context& context, const ast::IndexExpr& expr, Span span) {
  const auto* inner = context.GetIf<ast::IndexExpr>(expr.base);
  const auto* member = inner ? context.GetIf<ast::MemberExpr>(inner->base) : nullptr;
  if (!member || context[member->name] != "mips") return {};
  const ir::ExprId object = CheckExpr(context, member->base);
  if (context.TypeOf(object).kind != ir::TypeKind::kObject) {
    if (!context.IsError(object))
      ReportNoMember(context, context.TypeIdOf(object), member->name, member->name_span);
    return context.ErrorExpr(span);
  }
  const ir::ExprId level = CheckExpr(context, inner->index);
  const ir::ExprId index = CheckExpr(context, expr.index);
  if (context.IsError(level, index)) return context.ErrorExpr(span);
  return CheckObjectIndex(context.program, object, index, level, span, context.diagnostics);
}

// The index as a scalar int or uint.
ir::ExprId ConvertIndex(Context& context, ir::ExprId index) {
  const ir::Type& type = context.TypeOf(index);
  const Span span = context[index].span;
  if (!type.IsNumeric() || type.Components() != 1) {
    return context.Fail(span, diag::IndexNotScalar, context.TypeName(index));
  }
  const bool is_unsigned = ir::IsUnsigned(type.scalar) || type.scalar == ir::Scalar::kBool;
  return ConvertSilently(context, index,
                         context.types.Make(is_unsigned ? ir::Scalar::kUint : ir::Scalar::kInt));
}

bool CheckBounds(Context& context, ir::ExprId base, ir::ExprId index) {
  const ir::Type& type = context.TypeOf(base);
  const std::uint32_t bound = type.kind == ir::TypeKind::kArray    ? type.count
                              : type.kind == ir::TypeKind::kMatrix ? type.rows
                                                                   : type.columns;
  const auto value = EvaluateInteger(context.program, index);
  if (!value || (*value >= 0 && *value < bound)) return true;
  context.Report(context[index].span, diag::IndexOutOfBounds, *value, context.TypeName(base),
                 bound);
  return false;
}

}  // namespace

ir::ExprId CheckIndex(Context& context, const ast::IndexExpr& expr, Span span) {
  if (const ir::ExprId mips = CheckMips(context, expr, span)) return mips;
  const ir::ExprId base = CheckExpr(context, expr.base);
  ir::ExprId index = CheckExpr(context, expr.index);
  if (context.IsError(base, index)) return context.ErrorExpr(span);
  const ir::Type type = context.TypeOf(base);
  switch (type.kind) {
    case ir::TypeKind::kObject:
      return CheckObjectIndex(context.program, base, index, std::nullopt, span,
                              context.diagnostics);
    case ir::TypeKind::kArray:
    case ir::TypeKind::kVector:
    case ir::TypeKind::kMatrix: break;
    case ir::TypeKind::kStruct: {
      const ir::ExprId operands[] = {base, index};
      if (const auto call = CallOperator(context, "[]", operands, span, span)) return *call;
      [[fallthrough]];
    }
    default: return context.Fail(span, diag::NotIndexable, context.TypeName(base));
  }
  index = ConvertIndex(context, index);
  if (context.IsError(index)) return index;
  const auto* literal = context.GetIf<ir::Literal>(index);
  if (!CheckBounds(context, base, index)) return context.ErrorExpr(span);
  if (literal && context.Is<ir::Swizzle>(base)) {
    return Component(context, base, static_cast<std::uint8_t>(literal->bits));
  }
  return context.At(span).At(base, index);
}

}  // namespace clipc::check
