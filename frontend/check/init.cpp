// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/init.h"

#include <algorithm>

#include "frontend/check/assign.h"
#include "frontend/check/construct.h"
#include "frontend/check/expr.h"
#include "frontend/check/type.h"
#include "frontend/check/value.h"

namespace clipc::check {
namespace {

// The elements of a list that are not lists, in order, checked one after another as they are
// needed.
struct Leaves {
  std::vector<ast::ExprId> sources;
  std::size_t next = 0;
  ir::ExprId current;               // checked, not used yet
  std::vector<ir::ExprId> scalars;  // of an element that is dealt out one by one
  std::size_t next_scalar = 0;
  std::vector<ir::ExprId> prologue;
  bool ran_out = false;
  bool failed = false;  // an error was reported
};

ir::ExprId Take(Context& context, Leaves& leaves, ir::TypeId type_id);

void CollectLeaves(const Context& context, ast::ExprId init, std::vector<ast::ExprId>& leaves) {
  const auto* list = context.GetIf<ast::InitListExpr>(init);
  if (!list) return leaves.push_back(init);
  for (ast::ExprId element : context[list->elements]) CollectLeaves(context, element, leaves);
}

// Makes leaves.current the next element, if there is one and none is being dealt out.
bool Peek(Context& context, Leaves& leaves) {
  if (leaves.next_scalar < leaves.scalars.size()) return false;
  if (leaves.current) return true;
  if (leaves.next == leaves.sources.size() || leaves.failed) return false;
  leaves.current = CheckExpr(context, leaves.sources[leaves.next++]);
  leaves.failed = context.IsError(leaves.current);
  return !leaves.failed;
}

void OpenPart(Context& context, ir::ExprId value, Leaves& leaves) {
  ir::Builder at = context.At(context[value].span);
  const ir::Type type = context.TypeOf(value);
  if (type.kind == ir::TypeKind::kStruct) {
    const std::size_t count = context[type.structure].fields.size();
    for (std::uint32_t i = 0; i < count; ++i)
      OpenPart(context, at.Field(ir::Clone(context.program, value), i), leaves);
  } else if (type.kind == ir::TypeKind::kArray) {
    for (std::uint32_t i = 0; i < type.count; ++i)
      OpenPart(context, at.At(ir::Clone(context.program, value), i), leaves);
  } else {
    TakeApart(context, value, leaves.scalars, leaves.prologue);
  }
}

// Has leaves.current dealt out component by component.
void Open(Context& context, Leaves& leaves) {
  const ir::ExprId value = std::exchange(leaves.current, {});
  leaves.scalars.clear();
  leaves.next_scalar = 0;
  const ir::TypeId type = context.TypeIdOf(value);
  if (context[type].IsNumeric()) return TakeApart(context, value, leaves.scalars, leaves.prologue);
  const auto kinds = Flatten(context.program.types, type);
  if (!kinds) {
    context.Report(context[value].span, diag::CannotTakeApart, context.TypeName(type));
    leaves.failed = true;
    return;
  }
  const ir::ExprId object = IsPath(context, value) && ir::IsPure(context.program, value)
                                ? value
                                : Hoist(context, value, leaves.prologue);
  OpenPart(context, object, leaves);
}

ir::ExprId TakeScalar(Context& context, Leaves& leaves, ir::Scalar kind) {
  if (Peek(context, leaves)) Open(context, leaves);
  if (leaves.next_scalar >= leaves.scalars.size()) {
    leaves.ran_out = true;
    return context.ErrorExpr({});
  }
  return Implicit(context, leaves.scalars[leaves.next_scalar++], context.program.types.Make(kind));
}

ir::ExprId TakeVector(Context& context, Leaves& leaves, ir::TypeId type_id) {
  const ir::Type type = context[type_id];
  std::vector<ir::ExprId> parts;
  std::uint32_t filled = 0;
  while (filled < type.columns && !leaves.ran_out && !leaves.failed) {
    const bool has_current = Peek(context, leaves);
    const ir::Type given = has_current ? context.TypeOf(leaves.current) : ir::Type{};
    const bool is_simple =
        given.kind == ir::TypeKind::kScalar || given.kind == ir::TypeKind::kVector;
    if (has_current && is_simple && filled + given.columns <= type.columns) {
      const ir::ExprId value = std::exchange(leaves.current, {});
      parts.push_back(Implicit(
          context, value, context.program.types.WithScalar(context.TypeIdOf(value), type.scalar)));
      filled += given.columns;
    } else {
      parts.push_back(TakeScalar(context, leaves, type.scalar));
      ++filled;
    }
  }
  const Span span = parts.empty() ? Span{} : context[parts.front()].span;
  return leaves.ran_out || leaves.failed ? context.ErrorExpr(span)
                                         : context.At(span).ConstructOf(type_id, parts);
}

// The rows of a matrix, the fields of a struct, the elements of an array.
ir::ExprId TakeParts(Context& context, Leaves& leaves, ir::TypeId type_id) {
  const ir::Type type = context[type_id];
  const bool is_struct = type.kind == ir::TypeKind::kStruct;
  const std::size_t count = is_struct ? context[type.structure].fields.size()
                            : type.kind == ir::TypeKind::kMatrix ? type.rows
                                                                 : type.count;
  std::vector<ir::ExprId> parts;
  for (std::size_t i = 0; i < count && !leaves.ran_out && !leaves.failed; ++i) {
    const ir::TypeId part = is_struct ? context[type.structure].fields[i].type
                            : type.kind == ir::TypeKind::kMatrix
                                ? context.program.types.Vector(type.scalar, type.columns)
                                : type.element;
    parts.push_back(Take(context, leaves, part));
  }
  const Span span = parts.empty() ? Span{} : context[parts.front()].span;
  return leaves.ran_out || leaves.failed ? context.ErrorExpr(span)
                                         : context.At(span).ConstructOf(type_id, parts);
}

ir::ExprId Take(Context& context, Leaves& leaves, ir::TypeId type_id) {
  if (leaves.ran_out || leaves.failed) return context.ErrorExpr({});
  const ir::Type type = context[type_id];
  if (Peek(context, leaves)) {
    // An element that is just what is wanted here stays whole.
    const ir::Type& given = context.TypeOf(leaves.current);
    const bool same_shape = type.IsNumeric() && given.IsNumeric() && given.rows == type.rows &&
                            given.columns == type.columns;
    if (context.TypeIdOf(leaves.current) == type_id || same_shape)
      return Implicit(context, std::exchange(leaves.current, {}), type_id);
  }
  switch (type.kind) {
    case ir::TypeKind::kScalar: return TakeScalar(context, leaves, type.scalar);
    case ir::TypeKind::kVector: return TakeVector(context, leaves, type_id);
    case ir::TypeKind::kMatrix:
    case ir::TypeKind::kStruct:
    case ir::TypeKind::kArray: return TakeParts(context, leaves, type_id);
    default: break;
  }
  if (!leaves.failed)
    context.Report(leaves.current ? context[leaves.current].span : Span{}, diag::NotConstructible,
                   context.TypeName(type_id));
  leaves.failed = true;
  return context.ErrorExpr({});
}

ir::ExprId CheckInitList(Context& context, ast::ExprId init, ir::TypeId type) {
  const Span span = context[init].span;
  if (context.IsError(type)) return context.ErrorExpr(span);
  Leaves leaves;
  CollectLeaves(context, init, leaves.sources);
  const ir::ExprId value = Take(context, leaves, type);
  if (leaves.failed) return context.ErrorExpr(span);
  if (leaves.ran_out || leaves.next < leaves.sources.size() ||
      leaves.next_scalar < leaves.scalars.size() || leaves.current) {
    const std::string given = leaves.ran_out ? "too few" : "too many";
    return context.Fail(span, diag::InitialiserCount, given, context.TypeName(type),
                        ComponentsOf(context, type));
  }
  return WithPrologue(context, leaves.prologue, value);
}

// Nothing after an error, which was reported.
std::optional<std::uint64_t> CountComponents(Context& context, ast::ExprId init) {
  const auto& node = context[init].node;
  if (const auto* list = std::get_if<ast::InitListExpr>(&node)) {
    std::uint64_t total = 0;
    for (std::uint32_t i = 0; i < list->elements.size; ++i) {
      const auto count = CountComponents(context, context[list->elements][i]);
      if (!count) return std::nullopt;
      total += *count;
    }
    return total;
  }
  if (std::holds_alternative<ast::Literal>(node)) return 1;
  if (const auto* unary = std::get_if<ast::UnaryExpr>(&node))
    return CountComponents(context, unary->operand);
  const auto* call = std::get_if<ast::CallExpr>(&node);
  const auto* callee = call ? context.GetIf<ast::TypeExpr>(call->callee) : nullptr;
  const ir::TypeId type =
      callee ? ResolveType(context, callee->type) : context.TypeIdOf(CheckExpr(context, init));
  if (context.IsError(type)) return std::nullopt;
  return ComponentsOf(context, type);
}

}  // namespace

ir::ExprId CheckInit(Context& context, ast::ExprId init, ir::TypeId type) {
  if (context.Is<ast::InitListExpr>(init)) return CheckInitList(context, init, type);
  const ir::ExprId value = CheckExpr(context, init);
  return context.IsError(value) ? value : Implicit(context, value, type);
}

std::optional<std::uint32_t> ImpliedCount(Context& context, ast::ExprId init, ir::TypeId element) {
  const auto total = CountComponents(context, init);
  if (!total) return std::nullopt;
  const std::uint64_t each = std::max<std::uint64_t>(ComponentsOf(context, element), 1);
  if (*total == 0 || *total % each != 0 || *total / each > ~std::uint32_t{0}) {
    context.Report(context[init].span, diag::InitialiserNotWhole, *total, context.TypeName(element),
                   each);
    return std::nullopt;
  }
  return static_cast<std::uint32_t>(*total / each);
}

}  // namespace clipc::check
