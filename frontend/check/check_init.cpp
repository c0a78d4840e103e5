// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/check/checker.h"

// Initialisers. HLSL does not care how the braces of a list nest: the list is one row of
// components, dealt out to the components of the type in order.
namespace clipc {

// The elements of a list that are not lists, in order, checked one after another as they are
// needed.
struct Checker::Leaves {
  std::vector<ast::ExprId> sources;
  std::size_t next = 0;
  ir::ExprId current;               // checked, not used yet
  std::vector<ir::ExprId> scalars;  // of an element that is dealt out one by one
  std::size_t next_scalar = 0;
  std::vector<ir::ExprId> prologue;
  bool ran_out = false;
  bool failed = false;  // an error was reported
};

ir::ExprId Checker::CheckInit(ast::ExprId init, ir::TypeId type) {
  if (std::holds_alternative<ast::InitListExpr>(file_.exprs[init].node))
    return CheckInitList(init, type);
  const ir::ExprId value = CheckExpr(init);
  return IsError(value) ? value : Implicit(value, type);
}

void Checker::CollectLeaves(ast::ExprId init, std::vector<ast::ExprId>& leaves) const {
  const auto* list = std::get_if<ast::InitListExpr>(&file_.exprs[init].node);
  if (!list) return leaves.push_back(init);
  for (ast::ExprId element : file_.expr_lists[list->elements]) CollectLeaves(element, leaves);
}

ir::ExprId Checker::CheckInitList(ast::ExprId init, ir::TypeId type) {
  const Span span = file_.exprs[init].span;
  if (type == program_.types.Error()) return ErrorExpr(span);
  Leaves leaves;
  CollectLeaves(init, leaves.sources);
  const ir::ExprId value = Take(leaves, type);
  if (leaves.failed) return ErrorExpr(span);
  if (leaves.ran_out || leaves.next < leaves.sources.size() ||
      leaves.next_scalar < leaves.scalars.size() || leaves.current) {
    const std::string given = leaves.ran_out ? "too few" : "too many";
    diagnostics_.Report(span, diag::InitialiserCount, given, TypeName(type), ComponentsOf(type));
    return ErrorExpr(span);
  }
  return WithPrologue(leaves.prologue, value);
}

// Makes leaves.current the next element, if there is one and none is being dealt out.
bool Checker::Peek(Leaves& leaves) {
  if (leaves.next_scalar < leaves.scalars.size()) return false;
  if (leaves.current) return true;
  if (leaves.next == leaves.sources.size() || leaves.failed) return false;
  leaves.current = CheckExpr(leaves.sources[leaves.next++]);
  leaves.failed = IsError(leaves.current);
  return !leaves.failed;
}

// Has leaves.current dealt out component by component.
void Checker::Open(Leaves& leaves) {
  const ir::ExprId value = std::exchange(leaves.current, {});
  leaves.scalars.clear();
  leaves.next_scalar = 0;
  const ir::TypeId type = TypeIdOf(value);
  if (program_.types[type].IsNumeric()) return TakeApart(value, leaves.scalars, leaves.prologue);
  const auto kinds = Flatten(program_.types, type);
  if (!kinds) {
    diagnostics_.Report(program_.exprs[value].span, diag::CannotTakeApart, TypeName(type));
    leaves.failed = true;
    return;
  }
  const ir::ExprId object =
      IsPath(value) && ir::IsPure(program_, value) ? value : Hoist(value, leaves.prologue);
  OpenPart(object, leaves);
}

void Checker::OpenPart(ir::ExprId value, Leaves& leaves) {
  ir::Builder at = At(program_.exprs[value].span);
  const ir::Type type = TypeOf(value);
  if (type.kind == ir::TypeKind::kStruct) {
    const std::size_t count = program_.types[type.structure].fields.size();
    for (std::uint32_t i = 0; i < count; ++i)
      OpenPart(at.Field(ir::Clone(program_, value), i), leaves);
  } else if (type.kind == ir::TypeKind::kArray) {
    for (std::uint32_t i = 0; i < type.count; ++i)
      OpenPart(at.At(ir::Clone(program_, value), i), leaves);
  } else {
    TakeApart(value, leaves.scalars, leaves.prologue);
  }
}

ir::ExprId Checker::TakeScalar(Leaves& leaves, ir::Scalar kind) {
  if (Peek(leaves)) Open(leaves);
  if (leaves.next_scalar >= leaves.scalars.size()) {
    leaves.ran_out = true;
    return ErrorExpr({});
  }
  return Implicit(leaves.scalars[leaves.next_scalar++], program_.types.Make(kind));
}

ir::ExprId Checker::Take(Leaves& leaves, ir::TypeId type_id) {
  if (leaves.ran_out || leaves.failed) return ErrorExpr({});
  const ir::Type type = program_.types[type_id];
  if (Peek(leaves)) {
    // An element that is just what is wanted here stays whole.
    const ir::Type& given = TypeOf(leaves.current);
    const bool same_shape = type.IsNumeric() && given.IsNumeric() && given.rows == type.rows &&
                            given.columns == type.columns;
    if (TypeIdOf(leaves.current) == type_id || same_shape)
      return Implicit(std::exchange(leaves.current, {}), type_id);
  }
  switch (type.kind) {
    case ir::TypeKind::kScalar: return TakeScalar(leaves, type.scalar);
    case ir::TypeKind::kVector: return TakeVector(leaves, type_id);
    case ir::TypeKind::kMatrix:
    case ir::TypeKind::kStruct:
    case ir::TypeKind::kArray: return TakeParts(leaves, type_id);
    default: break;
  }
  if (!leaves.failed)
    diagnostics_.Report(leaves.current ? program_.exprs[leaves.current].span : Span{},
                        diag::NotConstructible, TypeName(type_id));
  leaves.failed = true;
  return ErrorExpr({});
}

ir::ExprId Checker::TakeVector(Leaves& leaves, ir::TypeId type_id) {
  const ir::Type type = program_.types[type_id];
  std::vector<ir::ExprId> parts;
  std::uint32_t filled = 0;
  while (filled < type.columns && !leaves.ran_out && !leaves.failed) {
    const bool has_current = Peek(leaves);
    const ir::Type given = has_current ? TypeOf(leaves.current) : ir::Type{};
    const bool is_simple =
        given.kind == ir::TypeKind::kScalar || given.kind == ir::TypeKind::kVector;
    if (has_current && is_simple && filled + given.columns <= type.columns) {
      const ir::ExprId value = std::exchange(leaves.current, {});
      parts.push_back(Implicit(value, program_.types.WithScalar(TypeIdOf(value), type.scalar)));
      filled += given.columns;
    } else {
      parts.push_back(TakeScalar(leaves, type.scalar));
      ++filled;
    }
  }
  const Span span = parts.empty() ? Span{} : program_.exprs[parts.front()].span;
  return leaves.ran_out || leaves.failed ? ErrorExpr(span) : At(span).ConstructOf(type_id, parts);
}

// The rows of a matrix, the fields of a struct, the elements of an array.
ir::ExprId Checker::TakeParts(Leaves& leaves, ir::TypeId type_id) {
  const ir::Type type = program_.types[type_id];
  const bool is_struct = type.kind == ir::TypeKind::kStruct;
  const std::size_t count = is_struct ? program_.types[type.structure].fields.size()
                            : type.kind == ir::TypeKind::kMatrix ? type.rows
                                                                 : type.count;
  std::vector<ir::ExprId> parts;
  for (std::size_t i = 0; i < count && !leaves.ran_out && !leaves.failed; ++i) {
    const ir::TypeId part = is_struct ? program_.types[type.structure].fields[i].type
                            : type.kind == ir::TypeKind::kMatrix
                                ? program_.types.Vector(type.scalar, type.columns)
                                : type.element;
    parts.push_back(Take(leaves, part));
  }
  const Span span = parts.empty() ? Span{} : program_.exprs[parts.front()].span;
  return leaves.ran_out || leaves.failed ? ErrorExpr(span) : At(span).ConstructOf(type_id, parts);
}

// The size of `T x[] = init`.
std::optional<std::uint32_t> Checker::ImpliedCount(ast::ExprId init, ir::TypeId element) {
  const auto total = CountComponents(init);
  if (!total) return std::nullopt;
  const std::uint64_t each = std::max<std::uint64_t>(ComponentsOf(element), 1);
  if (*total == 0 || *total % each != 0 || *total / each > ~std::uint32_t{0}) {
    diagnostics_.Report(file_.exprs[init].span, diag::InitialiserNotWhole, *total,
                        TypeName(element), each);
    return std::nullopt;
  }
  return static_cast<std::uint32_t>(*total / each);
}

// Nothing after an error, which was reported.
std::optional<std::uint64_t> Checker::CountComponents(ast::ExprId init) {
  const auto& node = file_.exprs[init].node;
  if (const auto* list = std::get_if<ast::InitListExpr>(&node)) {
    std::uint64_t total = 0;
    for (std::uint32_t i = 0; i < list->elements.size; ++i) {
      const auto count = CountComponents(file_.expr_lists[list->elements][i]);
      if (!count) return std::nullopt;
      total += *count;
    }
    return total;
  }
  if (std::holds_alternative<ast::Literal>(node)) return 1;
  if (const auto* unary = std::get_if<ast::UnaryExpr>(&node))
    return CountComponents(unary->operand);
  const auto* call = std::get_if<ast::CallExpr>(&node);
  const auto* callee = call ? std::get_if<ast::TypeExpr>(&file_.exprs[call->callee].node) : nullptr;
  const ir::TypeId type = callee ? ResolveType(callee->type) : TypeIdOf(CheckExpr(init));
  if (type == program_.types.Error()) return std::nullopt;
  return ComponentsOf(type);
}

}  // namespace clipc
