// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/member.h"

#include <algorithm>
#include <array>

#include "base/spelling.h"
#include "frontend/check/assign.h"
#include "frontend/check/bit_field.h"
#include "frontend/check/element.h"
#include "frontend/check/expr.h"
#include "frontend/check/struct.h"
#include "frontend/check/text.h"
#include "frontend/check/type.h"
#include "frontend/check/value.h"
#include "frontend/typing/objects.h"

namespace clipc::check {
namespace {

// The value of components of a matrix: part of a row if they lie in one, otherwise a MatrixSwizzle.
ExprId MatrixComponents(Context& context, MatrixSwizzle node, Span span) {
  Builder at = context.At(span);
  const auto same_row = [&](std::uint8_t row) { return row == node.rows[0]; };
  if (std::all_of(node.rows.begin(), node.rows.begin() + node.count, same_row)) {
    const ExprId row = at.At(node.base, std::uint32_t{node.rows[0]});
    if (node.count == 1) return at.At(row, std::uint32_t{node.columns[0]});
    return at.Swizzled(row, std::span<const std::uint8_t>(node.columns.data(), node.count));
  }
  Exprs prologue;
  const Scalar kind = context.TypeOf(node.base).scalar;
  if (RootOf(context.program, node.base) || ElementIn(context, node.base)) {
    FixIndices(context, node.base, false, prologue);
  } else {
    node.base = Hoist(context, node.base, prologue);
  }
  return WithPrologue(context, prologue, at.Add(context.types.Vector(kind, node.count), node));
}

// The swizzle .xyz or .rgb of `base`.
ExprId CheckSwizzle(Context& context, ExprId base, std::string_view text, Span name_span,
                    Span span) {
  const Type type = context.TypeOf(base);
  std::array<std::uint8_t, 4> components{};
  const std::string_view set =
      text.find_first_of("xyzw") != std::string_view::npos ? "xyzw" : "rgba";
  bool valid = !text.empty() && text.size() <= 4;
  for (std::size_t i = 0; valid && i < text.size(); ++i) {
    const std::size_t component = set.find(text[i]);
    valid = component != std::string_view::npos && component < type.columns;
    components[i] = static_cast<std::uint8_t>(component);
  }
  if (!valid) {
    return context.Fail(name_span, diag::BadSwizzle, text, context.TypeName(base));
  }
  const int count = static_cast<int>(text.size());
  if (type.kind == TypeKind::kScalar) {
    return count == 1 ? base
                      : context.At(span).SplatTo(context.types.Vector(type.scalar, count), base);
  }
  // A swizzle of a swizzle is one swizzle.
  if (const auto* inner = context.GetIf<Swizzle>(base)) {
    for (int i = 0; i < count; ++i) components[i] = inner->components[components[i]];
    base = inner->base;
  }
  Exprs steps;
  base = TakeSteps(context, base, steps);
  if (const auto* inner = context.GetIf<MatrixSwizzle>(base)) {
    MatrixSwizzle node{
        .base = inner->base, .rows = {}, .columns = {}, .count = static_cast<std::uint8_t>(count)};
    for (int i = 0; i < count; ++i) {
      node.rows[i] = inner->rows[components[i]];
      node.columns[i] = inner->columns[components[i]];
    }
    return WithPrologue(context, steps, MatrixComponents(context, node, span));
  }
  return context.At(span).Swizzled(base,
                                   std::span<const std::uint8_t>(components.data(), text.size()));
}

// The matrix swizzle ._m00_m11 or ._11_22 of `base`.
ExprId CheckMatrixSwizzle(Context& context, ExprId base, std::string_view text, Span name_span,
                          Span span) {
  const Type type = context.TypeOf(base);
  const bool from_zero = text.starts_with("_m");
  const std::size_t step = from_zero ? 4 : 3;
  const char first = from_zero ? '0' : '1';
  MatrixSwizzle node{.base = base, .rows = {}, .columns = {}, .count = 0};
  bool valid = !text.empty() && text.size() % step == 0 && text.size() / step <= 4;
  for (std::size_t i = 0; valid && i < text.size(); i += step) {
    const int row = text[i + step - 2] - first, column = text[i + step - 1] - first;
    valid = text[i] == '_' && (!from_zero || text[i + 1] == 'm') && row >= 0 && row < type.rows &&
            column >= 0 && column < type.columns;
    node.rows[node.count] = static_cast<std::uint8_t>(row);
    node.columns[node.count++] = static_cast<std::uint8_t>(column);
  }
  if (!valid) {
    return context.Fail(name_span, diag::BadSwizzle, text, context.TypeName(base));
  }
  return MatrixComponents(context, node, span);
}

// The number of elements of the array, which is still evaluated if that has effects.
ExprId ArrayLength(Context& context, ExprId array, Span span) {
  const auto count = static_cast<std::int32_t>(context.TypeOf(array).count);
  const ExprId length = context.At(span).Int(count);
  return IsPure(context.program, array) ? length : context.At(span).CommaOf(array, length);
}

// The static member S<int>::k.
ExprId StaticMember(Context& context, TypeId owner, const ast::MemberExpr& expr, Span span) {
  if (context.IsError(owner)) return context.ErrorExpr(span);
  const SymbolId member = FindMember(context, owner, expr.name);
  if (!member) {
    ReportNoMember(context, owner, expr.name, expr.name_span);
    return context.ErrorExpr(span);
  }
  if (context[member].kind == SymbolKind::kField) {
    const VarId self = context.view.body ? context.view.body->self : VarId{};
    const ExprId object = self ? context.At(expr.name_span).Ref(self) : ExprId{};
    if (const ExprId field =
            object ? FieldNamed(context, object, owner, expr.name, span) : ExprId{})
      return field;  // that of a base
    return context.Fail(expr.name_span, diag::FieldWithoutObject, context[expr.name]);
  }
  return UseSymbol(context, member, span);
}

// "; each element has it, `lights[i].color`" for an array whose elements have the member.
std::string ElementAdvice(Context& context, TypeId type, Name name, ast::ExprId base) {
  std::string indices;
  while (context[type].kind == TypeKind::kArray) {
    indices += fmt::format("[{}]", "ijk"[std::min<std::size_t>(indices.size() / 3, 2)]);
    type = context[type].element;
  }
  const bool is_swizzle = context[type].kind == TypeKind::kVector &&
                          context[name].find_first_not_of("xyzwrgba") == std::string_view::npos;
  const bool has_member = is_swizzle || FindMember(context, type, name);
  return base && !indices.empty() && has_member
             ? fmt::format("; each element has it, `{}{}.{}`", TextOf(context, base), indices,
                           context[name])
             : "";
}

// The type itself or the first of its bases that was declared with the name; none if none was.
TypeId BaseNamed(const Context& context, TypeId type, Name name) {
  const StructInfo* info = InfoOf(context, type);
  if (!info || context[info->scope].name == name) return info ? type : TypeId{};
  for (TypeId base : info->bases) {
    if (const TypeId found = BaseNamed(context, base, name)) return found;
  }
  return {};
}

// The struct whose method is being checked.
TypeId StructOfMethod(const Context& context) {
  ScopeId scope = context.view.scope;
  while (scope && context[scope].kind != ScopeKind::kStruct) scope = context[scope].parent;
  return scope ? context[scope].self : TypeId{};
}

}  // namespace

TypeId OwnerOf(Context& context, const ast::MemberExpr& expr, TypeId type) {
  if (context[type].kind != TypeKind::kStruct) return type;
  if (expr.of) {
    if (const TypeId base = BaseNamed(context, type, expr.of)) return base;
    return context.FailType(expr.name_span, diag::NoSuchMember, context.TypeName(type),
                            fmt::format("{}::{}", context[expr.of], context[expr.name]), "");
  }
  const auto* name = context.GetIf<ast::NameExpr>(expr.base);
  if (!name || !name->name.scopes.empty() || context[name->name.name] != "this") return type;
  const TypeId owner = StructOfMethod(context);
  return owner && FirstFieldOf(context, type, owner) ? owner : type;
}

ExprId CheckNode(Context& context, const ast::MemberExpr& expr, Span span) {
  if (const auto* owner = context.GetIf<ast::TypeExpr>(expr.base))
    return StaticMember(context, ResolveType(context, owner->type), expr, span);
  const ExprId base = CheckExpr(context, expr.base);
  if (context.IsError(base)) return base;
  const TypeId type = context.TypeIdOf(base);
  switch (context[type].kind) {
    case TypeKind::kScalar:
    case TypeKind::kVector:
      return CheckSwizzle(context, base, context[expr.name], expr.name_span, span);
    case TypeKind::kMatrix:
      return CheckMatrixSwizzle(context, base, context[expr.name], expr.name_span, span);
    case TypeKind::kArray:
      if (context[type].count == 0 || context[expr.name] != "Length") break;
      // fxc has this member; DXC calls it deprecated.
      return ArrayLength(context, base, span);
    case TypeKind::kObject:
      if (context[expr.name] != "Length") break;
      if (const ExprId length = CheckLength(context.program, base, span)) return length;
      break;
    default: break;
  }
  const TypeId owner = OwnerOf(context, expr, type);
  if (context.IsError(owner)) return context.ErrorExpr(span);
  if (const ExprId field = FieldNamed(context, base, owner, expr.name, span)) return field;
  const SymbolId member = FindMember(context, owner, expr.name);
  if (!member) {
    ReportNoMember(context, type, expr.name, expr.name_span, expr.base);
    return context.ErrorExpr(span);
  }
  return UseSymbol(context, member, span);
}

void ReportNoMember(Context& context, TypeId type, Name name, Span span, ast::ExprId base) {
  std::vector<std::string_view> candidates;
  if (const StructInfo* info = InfoOf(context, type)) {
    for (SymbolId id : context.names.symbol_ids()) {
      if (context[id].scope == info->scope) candidates.push_back(context[context[id].name]);
    }
  }
  const std::vector<std::string_view> near = NearNames(context[name], candidates);
  const std::string tail = near.empty() ? ElementAdvice(context, type, name, base)
                                        : fmt::format("; did you mean `{}`?", near.front());
  Diagnostic& report =
      context.Report(span, diag::NoSuchMember, context.TypeName(type), context[name], tail);
  if (!near.empty()) report.Fix(span, std::string(near.front()));
  if (const StructInfo* info = InfoOf(context, type)) {
    report.Note(context.types.StructOf(type).span, diag::DeclaredHere,
                context[context[info->scope].name]);
  }
}

}  // namespace clipc::check
