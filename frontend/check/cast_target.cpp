// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/cast_target.h"

#include <algorithm>
#include <vector>

#include "frontend/check/assign.h"
#include "frontend/check/type.h"
#include "frontend/check/value.h"
#include "ir/access.h"

namespace clipc::check {
namespace {

// The scalars and vectors that a value is made of, in order, taken one run of components at a time.
class Pieces {
 public:
  Pieces(Context& context, ExprId whole) : context_(context), whole_(whole) {
    Collect(context.TypeIdOf(whole));
  }

  bool at_end() const { return next_ == pieces_.size(); }
  int left() const { return pieces_[next_].size - offset_; }

  ExprId Take(int count) {
    const Piece& piece = pieces_[next_];
    Builder at = context_.At(context_[whole_].span);
    ExprId part = Clone(context_.program, whole_);
    for (const std::uint32_t step : piece.path) part = at.Part(part, step);
    const bool is_vector = context_.TypeOf(part).kind == TypeKind::kVector;
    if (is_vector && (count != piece.size || count == 1))
      part =
          at.SwizzledRun(part, static_cast<std::size_t>(offset_), static_cast<std::size_t>(count));
    offset_ += count;
    if (offset_ == piece.size) {
      offset_ = 0;
      ++next_;
    }
    return part;
  }

 private:
  struct Piece {
    std::vector<std::uint32_t> path;  // the numbers of the parts on the way to it
    int size;
  };

  void Collect(TypeId id) {
    const Type type = context_[id];
    if (type.IsScalarOrVector()) {
      pieces_.push_back({path_, type.columns});
      return;
    }
    for (std::uint32_t i = 0; i < context_.types.PartCount(id); ++i) {
      path_.push_back(i);
      Collect(context_.types.PartType(id, i));
      path_.pop_back();
    }
  }

  Context& context_;
  ExprId whole_;
  std::vector<std::uint32_t> path_;
  std::vector<Piece> pieces_;
  std::size_t next_ = 0;
  int offset_ = 0;
};

bool IsSameKind(Scalar one, Scalar other) {
  return (IsFloat(one) && IsFloat(other)) || BaseOf(one) == BaseOf(other);
}

}  // namespace

ast::ExprId PathOfCast(const Context& context, ExprId value, ast::ExprId operand, TypeId type) {
  if (RootOf(context.program, value)) return operand;
  const Type &inner = context.TypeOf(value), &outer = context[type];
  if (!inner.IsNumeric() || !outer.IsNumeric()) return {};
  // What is left of a matrix with fewer columns is not a run of its components.
  const bool fits = inner.kind == TypeKind::kMatrix && inner.Components() > 4
                        ? outer.kind == TypeKind::kMatrix && inner.rows >= outer.rows &&
                              inner.columns >= outer.columns
                        : inner.Components() >= outer.Components();
  return fits ? CastOperand(context, value) : ast::ExprId{};
}

void NoteCast(Context& context, ExprId value, ast::ExprId operand) {
  context.casts.insert_or_assign(value.index, operand);
}

ast::ExprId CastOperand(const Context& context, ExprId value) {
  const auto found = context.casts.find(value.index);
  return found == context.casts.end() ? ast::ExprId{} : found->second;
}

// Only fxc's 2.0 and 3.0 assign to a cast that changes the type of the components, whichever cast
// of several it is: vkd3d's lhs-cast.shader_test and lhs-partial-assignment.shader_test.
bool CheckCastTarget(Context& context, ExprId target, ast::ExprId cast, TypeId type) {
  if (!CheckTarget(context, target)) return false;
  const auto* outer = cast ? context.GetIf<ast::CastExpr>(cast) : nullptr;
  for (; outer && !context.program.profile.IsDirect3D9();
       outer = context.GetIf<ast::CastExpr>(outer->operand)) {
    const Type &from = context.TypeOf(target), &to = context[ResolveType(context, outer->type)];
    if (!from.IsNumeric() || !to.IsNumeric() || IsSameKind(from.scalar, to.scalar)) continue;
    context.Report(context[cast].span, diag::CastTargetKind, context.TypeName(target),
                   context.TypeName(ResolveType(context, outer->type)));
    return false;
  }
  const bool is_whole =
      ComponentsOf(context, context.TypeIdOf(target)) >= ComponentsOf(context, type);
  if (is_whole && !context.Is<MatrixSwizzle>(target) && !IsChosenComponent(context, target))
    return true;
  context.Report(context[target].span, diag::NotAssignable);
  return false;
}

ExprId WithoutCasts(Context& context, ExprId path) {
  Builder at = context.At(context[path].span);
  if (const auto* cast = context.GetIf<Convert>(path)) return WithoutCasts(context, cast->operand);
  if (const auto* swizzle = context.GetIf<Swizzle>(path)) {
    Swizzle node = *swizzle;
    ExprId base = WithoutCasts(context, node.base);
    if (!base) return base;
    if (const auto* inner = context.GetIf<Swizzle>(base)) {
      for (std::uint8_t& component : node.components) component = inner->components[component];
      base = inner->base;
    }
    return at.Swizzled(base, std::span(node.components).first(node.count));
  }
  return RootOf(context.program, path) ? path : ExprId{};
}

// A matrix stays in the upper left corner of one with more columns, as in fxc (vkd3d's
// lhs-partial-assignment.shader_test, checked against native).
void StoreComponents(Context& context, ExprId target, ExprId value, Exprs& steps) {
  const Type& whole = context.TypeOf(target);
  const Type& part = context.TypeOf(value);
  if (whole.kind == TypeKind::kMatrix && part.kind == TypeKind::kMatrix &&
      whole.columns > part.columns && whole.rows >= part.rows) {
    Builder at = context.At(context[target].span);
    for (std::uint32_t row = 0, rows = static_cast<std::uint32_t>(part.rows); row < rows; ++row) {
      StoreComponents(context, at.Part(Clone(context.program, target), row),
                      at.Part(Clone(context.program, value), row), steps);
    }
    return;
  }
  Pieces to(context, target), from(context, value);
  while (!from.at_end() && !to.at_end()) {
    const int count = std::min(from.left(), to.left());
    const ExprId place = to.Take(count);
    const ExprId part = ConvertSilently(context, from.Take(count), context.TypeIdOf(place));
    steps.push_back(context.At(context[target].span).AssignTo(place, part));
  }
}

}  // namespace clipc::check
