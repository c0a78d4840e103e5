// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/index.h"

#include "base/spelling.h"
#include "frontend/check/construct.h"
#include "frontend/check/expr.h"
#include "frontend/check/member.h"
#include "frontend/check/operator.h"
#include "frontend/check/value.h"
#include "frontend/typing/constant.h"
#include "frontend/typing/objects.h"

namespace clipc::check {
namespace {

// Whether the path names variables, members and elements alone, so that it may be checked twice.
bool IsPlainPath(const Context& context, ast::ExprId path) {
  if (const auto* member = context.GetIf<ast::MemberExpr>(path))
    return IsPlainPath(context, member->base);
  const auto* index = context.GetIf<ast::IndexExpr>(path);
  if (!index) return context.Is<ast::NameExpr>(path);
  return IsPlainPath(context, index->base) &&
         (context.Is<ast::Literal>(index->index) || IsPlainPath(context, index->index));
}

bool IsMultisampled(const Type& type) {
  return type.kind == TypeKind::kObject && ir::InfoOf(type.object).is_multisampled;
}

// The value of texture.mips[level][position], or of texture.sample[sample][position] where the
// texture is multisampled; none if the expression is something else.
ExprId CheckMips(Context& context, const ast::IndexExpr& expr, Span span) {
  const auto* inner = context.GetIf<ast::IndexExpr>(expr.base);
  const auto* member = inner ? context.GetIf<ast::MemberExpr>(inner->base) : nullptr;
  const std::string_view name = member ? context[member->name] : std::string_view();
  // A field of a struct may be called `sample`.
  if (name != "mips" && (name != "sample" || !IsPlainPath(context, member->base))) return {};
  const ExprId object = CheckExpr(context, member->base);
  if (name == "sample" && !IsMultisampled(context.TypeOf(object))) return {};
  if (context.TypeOf(object).kind != TypeKind::kObject) {
    if (!context.IsError(object))
      ReportNoMember(context, context.TypeIdOf(object), member->name, member->name_span);
    return context.ErrorExpr(span);
  }
  const ExprId level = CheckExpr(context, inner->index);
  const ExprId index = CheckExpr(context, expr.index);
  if (context.IsError(level, index)) return context.ErrorExpr(span);
  return CheckObjectIndex(context.program, {object, index, level, span}, context.diagnostics);
}

// The index as a scalar int or uint.
ExprId ConvertIndex(Context& context, ExprId index) {
  const Type& type = context.TypeOf(index);
  const Span span = context[index].span;
  if (!type.IsNumeric() || type.Components() != 1) {
    return context.Fail(span, diag::IndexNotScalar, context.TypeName(index));
  }
  const bool is_unsigned = IsUnsigned(type.scalar) || type.scalar == Scalar::kBool;
  return ConvertSilently(context, index,
                         context.types.Make(is_unsigned ? Scalar::kUint : Scalar::kInt));
}

bool CheckBounds(Context& context, ExprId base, ExprId index) {
  const Type& type = context.TypeOf(base);
  const std::uint32_t bound = type.kind == TypeKind::kArray    ? type.count
                              : type.kind == TypeKind::kMatrix ? type.rows
                                                               : type.columns;
  if (bound == 0) return true;  // an array without a size
  const auto value = EvaluateInteger(context.program, index);
  if (!value || (*value >= 0 && *value < bound)) return true;
  context.Report(context[index].span, diag::IndexOutOfBounds, *value, context.TypeName(base),
                 WithCount(bound, "element"));
  return false;
}

}  // namespace

ExprId CheckNode(Context& context, const ast::IndexExpr& expr, Span span) {
  if (const ExprId mips = CheckMips(context, expr, span)) return mips;
  const ExprId base = CheckExpr(context, expr.base);
  ExprId index = CheckExpr(context, expr.index);
  if (context.IsError(base, index)) return context.ErrorExpr(span);
  const Type type = context.TypeOf(base);
  switch (type.kind) {
    case TypeKind::kObject:
      return CheckObjectIndex(context.program, {base, index, std::nullopt, span},
                              context.diagnostics);
    case TypeKind::kArray:
    case TypeKind::kVector:
    case TypeKind::kMatrix: break;
    case TypeKind::kStruct: {
      const ExprId operands[] = {base, index};
      if (const auto call = CallOperator(context, "[]", operands, span, span)) return *call;
      [[fallthrough]];
    }
    default: return context.Fail(span, diag::NotIndexable, context.TypeName(base));
  }
  index = ConvertIndex(context, index);
  if (context.IsError(index)) return index;
  const auto* literal = context.GetIf<Literal>(index);
  if (!CheckBounds(context, base, index)) return context.ErrorExpr(span);
  if (literal && (context.Is<Swizzle>(base) || context.Is<MatrixSwizzle>(base))) {
    return Component(context, base, static_cast<std::uint8_t>(literal->bits));
  }
  // fxc evaluates the index of a value first, dxc the value (vkd3d's side-effects.shader_test,
  // checked against native).
  Exprs prologue;
  if (!context.program.profile.IsAtLeast(6, 0) && !RootOf(context.program, base) &&
      !IsPure(context.program, base) && !IsPure(context.program, index))
    index = Hoist(context, index, prologue);
  return WithPrologue(context, prologue, context.At(span).At(base, index));
}

}  // namespace clipc::check
