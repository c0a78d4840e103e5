// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/legalize/ranges.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "ir/access.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

constexpr int kMaxNesting = 4;  // depth of constants named in values of constants: bounds the stack

Range Union(const Range& a, const Range& b) {
  return {std::min(a.least, b.least), std::max(a.most, b.most)};
}

Range OfProducts(const Range& a, const Range& b) {
  const double products[] = {a.least * b.least, a.least * b.most, a.most * b.least,
                             a.most * b.most};
  return {std::ranges::min(products), std::ranges::max(products)};
}

Range OfKind(Scalar kind) {
  switch (BaseOf(kind)) {
    case Scalar::kBool: return {0, 1};
    case Scalar::kInt: return {-0x1p31, 0x1p31 - 1};
    case Scalar::kUint: return {0, 0x1p32 - 1};
    default: return {};
  }
}

}  // namespace

class RangeFinder {
 public:
  explicit RangeFinder(Ranges& ranges) : ranges_(ranges), program_(ranges.program_) {}

  Range Of(ExprId expr) {
    return std::visit([&](const auto& node) { return OfNode(expr, node); },
                      program_.exprs[expr].node);
  }

 private:
  Range OfNode(ExprId expr, const Literal& node) {
    const double value = NumberOf(node.bits, TypeOf(program_, expr).scalar);
    return std::isfinite(value) ? Range{value, value} : Range{};
  }
  Range OfNode(ExprId, const Zero&) { return {0, 0}; }
  Range OfNode(ExprId expr, const VarRef& node) {
    const Var& var = program_.vars[node.var];
    if (var.storage != Storage::kConstant || !var.init) return Anything(expr);
    auto& known = ranges_.of_constants_;
    if (known.size() <= node.var.index) known.resize(program_.vars.size());
    if (known[node.var.index]) return *known[node.var.index];
    if (nesting_ >= kMaxNesting) return Anything(expr);
    ++nesting_;
    const Range range = Of(var.init);
    --nesting_;
    known[node.var.index] = range;
    return range;
  }
  Range OfNode(ExprId, const Swizzle& node) { return Of(node.base); }
  Range OfNode(ExprId, const Splat& node) { return Of(node.operand); }
  Range OfNode(ExprId expr, const Construct& node) {
    if (!TypeOf(program_, expr).IsNumeric()) return {};
    const auto parts = program_.expr_lists[node.arguments];
    Range range = Of(parts[0]);
    for (const ExprId part : parts.subspan(1)) range = Union(range, Of(part));
    return range;
  }
  Range OfNode(ExprId, const Conditional& node) {
    return Union(Of(node.when_true), Of(node.when_false));
  }
  Range OfNode(ExprId, const Select& node) {
    return Union(Of(node.when_true), Of(node.when_false));
  }
  Range OfNode(ExprId expr, const Unary& node) {
    if (node.op != UnaryOp::kNegate || !IsFloating(expr)) return Anything(expr);
    const Range range = Of(node.operand);
    return {-range.most, -range.least};
  }
  Range OfNode(ExprId expr, const Convert& node) {
    const Range range = Of(node.operand);
    const Range whole = OfKind(TypeOf(program_, expr).scalar);
    return range.IsWithin(whole.least, whole.most) ? range : whole;
  }
  // Integers wrap round, so nothing is known about their sums and products.
  Range OfNode(ExprId expr, const Binary& node) {
    if (!IsFloating(expr))
      return node.op == BinaryOp::kBitAnd ? OfMask(expr, node) : Anything(expr);
    const Range left = Of(node.left), right = Of(node.right);
    if (!left.IsKnown() || !right.IsKnown()) return {};
    switch (node.op) {
      case BinaryOp::kAdd: return {left.least + right.least, left.most + right.most};
      case BinaryOp::kSub: return {left.least - right.most, left.most - right.least};
      case BinaryOp::kMul: return OfProducts(left, right);
      default: return {};
    }
  }
  Range OfNode(ExprId expr, const IntrinsicCall& node) {
    const auto arguments = program_.expr_lists[node.arguments];
    switch (node.op) {
      case Intrinsic::kSaturate:
      case Intrinsic::kStep: return {0, 1};
      case Intrinsic::kFloor:
      case Intrinsic::kCeil:
      case Intrinsic::kRound: {
        const Range range = Of(arguments[0]);
        return {std::floor(range.least), std::ceil(range.most)};
      }
      case Intrinsic::kTrunc: return Of(arguments[0]);
      case Intrinsic::kAbs: {
        const Range range = Of(arguments[0]);
        return {0, std::max(std::fabs(range.least), std::fabs(range.most))};
      }
      // Where one argument is NaN, the value is the other one.
      case Intrinsic::kClamp: {
        const Range low = Of(arguments[1]), high = Of(arguments[2]);
        return {std::min(low.least, high.least), std::max(low.most, high.most)};
      }
      case Intrinsic::kMin: {
        const Range a = Of(arguments[0]), b = Of(arguments[1]);
        return {std::min(a.least, b.least), std::min(a.most, b.most)};
      }
      case Intrinsic::kMax: {
        const Range a = Of(arguments[0]), b = Of(arguments[1]);
        return {std::max(a.least, b.least), std::max(a.most, b.most)};
      }
      default: return Anything(expr);
    }
  }
  Range OfNode(ExprId expr, const auto&) { return Anything(expr); }

  Range OfMask(ExprId expr, const Binary& node) {
    const Range mask = Of(node.right);
    return mask.least >= 0 ? Range{0, mask.most} : Anything(expr);
  }

  bool IsFloating(ExprId expr) const { return IsFloat(TypeOf(program_, expr).scalar); }
  Range Anything(ExprId expr) const { return OfKind(TypeOf(program_, expr).scalar); }

  Ranges& ranges_;
  const Program& program_;
  int nesting_ = 0;  // the number of constants whose values are being visited
};

Range Ranges::Of(ExprId expr) { return RangeFinder(*this).Of(expr); }

}  // namespace clipc::glsl
