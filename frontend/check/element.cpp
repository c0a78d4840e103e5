// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/element.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "frontend/check/assign.h"
#include "frontend/check/value.h"

namespace clipc::check {
namespace {

// Neighbours in a row of the vector or matrix among the components of a swizzle: one store writes
// them.
struct Piece {
  std::uint32_t row = 0, column = 0;     // of the first
  std::vector<std::uint8_t> of_swizzle;  // where the swizzle has each of them
};

// The pieces of a swizzle; empty for other targets.
std::vector<Piece> PiecesOf(const Context& context, ExprId target) {
  const auto* vector = context.GetIf<Swizzle>(target);
  const auto* matrix = context.GetIf<MatrixSwizzle>(target);
  const int count = vector ? vector->count : matrix ? matrix->count : 0;
  const auto place_of = [&](std::uint8_t i) {
    return matrix ? std::pair<std::uint32_t, std::uint32_t>{matrix->rows[i], matrix->columns[i]}
                  : std::pair<std::uint32_t, std::uint32_t>{0, vector->components[i]};
  };
  std::vector<std::uint8_t> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), std::uint8_t{0});
  std::ranges::sort(order, {}, place_of);
  std::vector<Piece> pieces;
  for (const std::uint8_t i : order) {
    const auto [row, column] = place_of(i);
    const bool goes_on = !pieces.empty() && pieces.back().row == row &&
                         pieces.back().column + pieces.back().of_swizzle.size() == column;
    if (!goes_on) pieces.push_back({row, column, {}});
    pieces.back().of_swizzle.push_back(i);
  }
  return pieces;
}

// The components of a piece in a value of the swizzle's type.
ExprId ValueOf(Context& context, const Piece& piece, ExprId value) {
  Builder at = context.At(context[value].span);
  if (const auto* swizzle = context.GetIf<Swizzle>(value)) {
    const Swizzle whole = *swizzle;
    std::vector<std::uint8_t> components;
    for (const std::uint8_t i : piece.of_swizzle) components.push_back(whole.components[i]);
    return at.Swizzled(Clone(context.program, whole.base), components);
  }
  const auto* matrix = context.GetIf<MatrixSwizzle>(value);
  if (!matrix) return at.Swizzled(Clone(context.program, value), piece.of_swizzle);
  const ExprId row = at.At(Clone(context.program, matrix->base), piece.row);
  return at.SwizzledRun(row, piece.column, piece.of_swizzle.size());
}

// The store object[place] = value, of a part of the element if there are steps to it.
ExprId Store(Context& context, ExprId element, ExprSpan steps, ExprId value, Span span) {
  const auto load = context.Get<ObjectCall>(element);
  std::vector<NamedOperand> operands;
  for (const OperandKind kind : {OperandKind::kObject, OperandKind::kPlace})
    operands.push_back({kind, Clone(context.program, OperandOf(context.program, load, kind))});
  for (const ExprId step : steps)
    operands.push_back({OperandKind::kStep, Clone(context.program, step)});
  operands.push_back({OperandKind::kValue, value});
  return context.At(span).ObjectCallOf(ObjectOp::kStore, context.types.Void(), operands);
}

// The stores of `value` to `target`, a part of `element`. Empty if no steps lead to it.
Exprs StoresOf(Context& context, ExprId element, ExprId target, ExprId value, Span span) {
  if (const auto steps = StepsTo(context.program, target, element))
    return {Store(context, element, *steps, value, span)};
  const std::vector<Piece> pieces = PiecesOf(context, target);
  if (pieces.empty()) return {};
  const auto steps = StepsTo(context.program, WholeOf(context.program, target), element);
  if (!steps) return {};
  Exprs stores;
  for (const Piece& piece : pieces) {
    Exprs part(steps->begin(), steps->end());
    Builder at = context.At(span);
    if (context.Is<MatrixSwizzle>(target)) part.push_back(at.Uint(piece.row));
    part.push_back(at.Uint(piece.column));
    stores.push_back(Store(context, element, part, ValueOf(context, piece, value), span));
  }
  return stores;
}

// Whether a store can name `target` in `element`: the whole, or a part of a structured buffer's.
bool CanStore(Context& context, ExprId element, ExprId target) {
  if (target == element) return true;
  if (context.Get<ObjectCall>(element).op != ObjectOp::kStructuredLoad) return false;
  const auto* index = context.GetIf<Index>(target);
  if (RepeatsComponents(context.program, index ? index->base : target)) return false;
  if (StepsTo(context.program, target, element)) return true;
  return !PiecesOf(context, target).empty() &&
         StepsTo(context.program, WholeOf(context.program, target), element).has_value();
}

}  // namespace

ExprId ElementIn(const Context& context, ExprId expr) {
  while (const ExprId whole = WholeOf(context.program, expr)) expr = whole;
  const auto* call = context.GetIf<ObjectCall>(expr);
  if (!call) return {};
  const ExprId object = OperandOf(context.program, *call, OperandKind::kObject);
  const bool is_element = LoadsElement(call->op) && IsWritable(context.TypeOf(object).object);
  return is_element ? expr : ExprId{};
}

bool StaysTheSame(const Context& context, ExprId value) {
  if (context.Is<Literal>(value)) return true;
  const VarId root = RootOf(context.program, value);
  return root && HasLiteralIndices(context.program, value) &&
         (IsConstVar(context, root) || context[root].storage == Storage::kUniform);
}

void FixIndices(Context& context, ExprId path, bool may_change, Exprs& prologue) {
  const auto fixed = [&](ExprId index) {
    const bool stays = may_change ? StaysTheSame(context, index) : IsPure(context.program, index);
    return stays ? index : Hoist(context, index, prologue);
  };
  if (const auto* load = context.GetIf<ObjectCall>(path)) {
    const List<ExprId> place = OperandsOf(*load, OperandKind::kPlace);
    const ExprId index = fixed(context[place][0]);
    context.program.expr_lists[place][0] = index;
  } else if (const ExprId whole = WholeOf(context.program, path)) {
    FixIndices(context, whole, may_change, prologue);
    if (const auto* found = context.GetIf<Index>(path)) {
      const Index index = *found;
      context[path].node = Index{index.base, fixed(index.index)};
    }
  }
}

ExprId StoreToElement(Context& context, const ElementTarget& to, ExprId value, Span span) {
  const auto [element, target, is_used] = to;
  if (!CanStore(context, element, target)) return {};
  Exprs steps;
  if (is_used || PiecesOf(context, target).size() > 1) {
    FixIndices(context, target, !IsPure(context.program, value), steps);
    value = Repeatable(context, value, steps);
  }
  Exprs stores = StoresOf(context, element, target, value, span);
  if (is_used) stores.push_back(Clone(context.program, value));
  steps.insert(steps.end(), stores.begin(), stores.end() - 1);
  return WithPrologue(context, steps, stores.back());
}

Exprs ChangeElement(Context& context, ExprId element, ExprId target, bool may_change,
                    Exprs& prologue) {
  const Span span = context[element].span;
  FixIndices(context, target, may_change, prologue);
  const ExprId copy = Hoist(context, Clone(context.program, element), prologue);
  ExprId part = target;  // the smallest one around the target that can be stored
  while (!CanStore(context, element, part)) part = WholeOf(context.program, part);
  const ExprId value = Clone(context.program, part);
  ExprId root = value;
  while (const ExprId whole = WholeOf(context.program, root)) root = whole;
  context[root].node = context[copy].node;
  Exprs stores = StoresOf(context, element, part, value, span);
  context[element].node = context[copy].node;
  return stores;
}

}  // namespace clipc::check
