// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <array>

#include "base/spelling.h"
#include "frontend/check/checker.h"
#include "frontend/rules/constant.h"
#include "frontend/rules/intrinsics.h"

// What follows a `.` that is no method call, and what stands in brackets.
namespace clipc {

ir::ExprId Checker::CheckMember(const ast::MemberExpr& expr, Span span) {
  const ir::ExprId base = CheckExpr(expr.base);
  if (IsError(base)) return base;
  const ir::TypeId type = TypeIdOf(base);
  switch (program_.types[type].kind) {
    case ir::TypeKind::kScalar:
    case ir::TypeKind::kVector: return CheckSwizzle(base, Text(expr.name), expr.name_span, span);
    case ir::TypeKind::kMatrix:
      return CheckMatrixSwizzle(base, Text(expr.name), expr.name_span, span);
    default: break;
  }
  if (const auto field = FindField(type, expr.name)) return At(span).Field(base, *field);
  const SymbolId member = FindMember(type, expr.name);
  if (!member) {
    ReportNoMember(type, expr.name, expr.name_span);
    return ErrorExpr(span);
  }
  return UseSymbol(member, span);
}

void Checker::ReportNoMember(ir::TypeId type, Name name, Span span) {
  std::vector<std::string_view> candidates;
  if (const StructInfo* info = InfoOf(type)) {
    for (SymbolId id : symbols_.ids()) {
      if (symbols_[id].scope == info->scope) candidates.push_back(Text(symbols_[id].name));
    }
  }
  const std::vector<std::string_view> near = NearNames(Text(name), candidates);
  const std::string tail = near.empty() ? "" : fmt::format("; did you mean `{}`?", near.front());
  Diagnostic& report =
      diagnostics_.Report(span, diag::NoSuchMember, TypeName(type), Text(name), tail);
  if (!near.empty()) report.Fix(span, std::string(near.front()));
  if (const StructInfo* info = InfoOf(type)) {
    report.Note(program_.types.StructOf(type).span, diag::DeclaredHere,
                Text(scopes_[info->scope].name));
  }
}

// .xyz, .rgb
ir::ExprId Checker::CheckSwizzle(ir::ExprId base, std::string_view text, Span name_span,
                                 Span span) {
  const ir::Type type = TypeOf(base);
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
    diagnostics_.Report(name_span, diag::BadSwizzle, text, TypeName(TypeIdOf(base)));
    return ErrorExpr(span);
  }
  const int count = static_cast<int>(text.size());
  if (type.kind == ir::TypeKind::kScalar) {
    return count == 1 ? base : At(span).SplatTo(program_.types.Vector(type.scalar, count), base);
  }
  // A swizzle of a swizzle is one.
  if (const auto* inner = std::get_if<ir::Swizzle>(&program_.exprs[base].node)) {
    for (int i = 0; i < count; ++i) components[i] = inner->components[components[i]];
    base = inner->base;
  }
  return At(span).Swizzled(base, std::span<const std::uint8_t>(components.data(), text.size()));
}

// ._m00_m11, ._11_22
ir::ExprId Checker::CheckMatrixSwizzle(ir::ExprId base, std::string_view text, Span name_span,
                                       Span span) {
  const ir::Type type = TypeOf(base);
  const bool from_zero = text.starts_with("_m");
  const std::size_t step = from_zero ? 4 : 3;
  const char first = from_zero ? '0' : '1';
  ir::MatrixSwizzle node{.base = base, .rows = {}, .columns = {}, .count = 0};
  bool valid = !text.empty() && text.size() % step == 0 && text.size() / step <= 4;
  for (std::size_t i = 0; valid && i < text.size(); i += step) {
    const int row = text[i + step - 2] - first, column = text[i + step - 1] - first;
    valid = text[i] == '_' && (!from_zero || text[i + 1] == 'm') && row >= 0 && row < type.rows &&
            column >= 0 && column < type.columns;
    node.rows[node.count] = static_cast<std::uint8_t>(row);
    node.columns[node.count++] = static_cast<std::uint8_t>(column);
  }
  if (!valid) {
    diagnostics_.Report(name_span, diag::BadSwizzle, text, TypeName(TypeIdOf(base)));
    return ErrorExpr(span);
  }
  ir::Builder at = At(span);
  const auto same_row = [&](std::uint8_t row) { return row == node.rows[0]; };
  if (std::all_of(node.rows.begin(), node.rows.begin() + node.count, same_row)) {
    const ir::ExprId row = at.At(base, std::uint32_t{node.rows[0]});
    if (node.count == 1) return at.At(row, std::uint32_t{node.columns[0]});
    return at.Swizzled(row, std::span<const std::uint8_t>(node.columns.data(), node.count));
  }
  std::vector<ir::ExprId> prologue;
  if (!IsPath(base) || !ir::IsPure(program_, base)) node.base = Hoist(base, prologue);
  return WithPrologue(prologue, at.Add(program_.types.Vector(type.scalar, node.count), node));
}

ir::ExprId Checker::CheckIndex(const ast::IndexExpr& expr, Span span) {
  if (const ir::ExprId mips = CheckMips(expr, span)) return mips;
  const ir::ExprId base = CheckExpr(expr.base);
  ir::ExprId index = CheckExpr(expr.index);
  if (IsError(base) || IsError(index)) return ErrorExpr(span);
  const ir::Type type = TypeOf(base);
  switch (type.kind) {
    case ir::TypeKind::kObject:
      return CheckObjectIndex(program_, base, index, std::nullopt, span, diagnostics_);
    case ir::TypeKind::kArray:
    case ir::TypeKind::kVector:
    case ir::TypeKind::kMatrix: break;
    case ir::TypeKind::kStruct: {
      const ir::ExprId operands[] = {base, index};
      if (const auto call = CallOperator("[]", operands, span, span)) return *call;
      [[fallthrough]];
    }
    default:
      diagnostics_.Report(span, diag::NotIndexable, TypeName(TypeIdOf(base)));
      return ErrorExpr(span);
  }
  index = ConvertIndex(index);
  if (IsError(index)) return index;
  const auto* literal = std::get_if<ir::Literal>(&program_.exprs[index].node);
  if (!CheckBounds(base, index)) return ErrorExpr(span);
  if (literal && std::holds_alternative<ir::Swizzle>(program_.exprs[base].node)) {
    return Component(base, static_cast<std::uint8_t>(literal->bits));
  }
  return At(span).At(base, index);
}

// texture.mips[level][position]; none when the expression is something else.
ir::ExprId Checker::CheckMips(const ast::IndexExpr& expr, Span span) {
  const auto* inner = std::get_if<ast::IndexExpr>(&file_.exprs[expr.base].node);
  const auto* member =
      inner ? std::get_if<ast::MemberExpr>(&file_.exprs[inner->base].node) : nullptr;
  if (!member || Text(member->name) != "mips") return {};
  const ir::ExprId object = CheckExpr(member->base);
  if (TypeOf(object).kind != ir::TypeKind::kObject) {
    if (!IsError(object)) ReportNoMember(TypeIdOf(object), member->name, member->name_span);
    return ErrorExpr(span);
  }
  const ir::ExprId level = CheckExpr(inner->index);
  const ir::ExprId index = CheckExpr(expr.index);
  if (IsError(level) || IsError(index)) return ErrorExpr(span);
  return CheckObjectIndex(program_, object, index, level, span, diagnostics_);
}

// An int or uint scalar.
ir::ExprId Checker::ConvertIndex(ir::ExprId index) {
  const ir::Type& type = TypeOf(index);
  const Span span = program_.exprs[index].span;
  if (!type.IsNumeric() || type.Components() != 1) {
    diagnostics_.Report(span, diag::IndexNotScalar, TypeName(TypeIdOf(index)));
    return ErrorExpr(span);
  }
  const bool is_unsigned = ir::IsUnsigned(type.scalar) || type.scalar == ir::Scalar::kBool;
  return ConvertSilently(index,
                         program_.types.Make(is_unsigned ? ir::Scalar::kUint : ir::Scalar::kInt));
}

bool Checker::CheckBounds(ir::ExprId base, ir::ExprId index) {
  const ir::Type& type = TypeOf(base);
  const std::uint32_t bound = type.kind == ir::TypeKind::kArray    ? type.count
                              : type.kind == ir::TypeKind::kMatrix ? type.rows
                                                                   : type.columns;
  const auto value = EvaluateInteger(program_, index);
  if (!value || (*value >= 0 && *value < bound)) return true;
  diagnostics_.Report(program_.exprs[index].span, diag::IndexOutOfBounds, *value,
                      TypeName(TypeIdOf(base)), bound);
  return false;
}

}  // namespace clipc
