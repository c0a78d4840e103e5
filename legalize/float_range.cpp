// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/float_range.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ir/access.h"
#include "ir/evaluate.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// No render target is larger ("Direct3D 11.3 Functional Specification", 21.4: 16384), nor is the
// range of a viewport.
constexpr double kLargestPlace = 32768;
// The operators of an expression that are looked through, so that nested conversions take linear
// time.
constexpr int kMaxDepth = 16;
// A float operation rounds by at most this part of its result, which keeps its sign.
constexpr double kRounding = 0x1p-23;

class RangeFinder {
 public:
  explicit RangeFinder(const Program& program) : program_(program) {}

  std::optional<FloatRange> Of(ExprId expr, int depth = 0) const {
    if (depth == 0 || As<Literal>(program_, expr) || As<VarRef>(program_, expr)) {
      if (const auto bits = ConstantBits(program_, expr))
        return OfConstant(*bits, TypeOf(program_, expr).scalar);
    }
    // What has fewer digits may be as small as 65504.
    const Scalar kind = TypeOf(program_, expr).scalar;
    if (depth == kMaxDepth || (kind != Scalar::kFloat && kind != Scalar::kDouble))
      return std::nullopt;
    const auto of = [&](ExprId operand) { return Of(operand, depth + 1); };
    return Visit(
        Overloaded{
            [&](const Swizzle& node) { return OfSwizzle(node, of); },
            [&](const Unary& node) {
              const auto range = of(node.operand);
              return range && node.op == UnaryOp::kNegate ? Range({-range->high, -range->low})
                                                          : std::nullopt;
            },
            [&](const Binary& node) { return OfBinary(node, of); },
            [&](const Convert& node) { return OfConversion(node, of); },
            [&](const Splat& node) { return of(node.operand); },
            [&](const Construct& node) { return OfAll(node.arguments, of); },
            [&](const Conditional& node) { return Union(of(node.when_true), of(node.when_false)); },
            [&](const IntrinsicCall& node) { return OfIntrinsic(node, of); },
            [](const auto&) { return Range(); },
        },
        program_.exprs[expr].node);
  }

 private:
  using Range = std::optional<FloatRange>;

  static Range Rounded(FloatRange range) {
    if (!std::isfinite(range.low) || !std::isfinite(range.high)) return std::nullopt;
    return FloatRange{range.low - std::abs(range.low) * kRounding,
                      range.high + std::abs(range.high) * kRounding};
  }
  static Range Union(const Range& a, const Range& b) {
    if (!a || !b) return std::nullopt;
    return FloatRange{std::min(a->low, b->low), std::max(a->high, b->high)};
  }

  static Range OfConstant(const std::vector<std::uint64_t>& bits, Scalar kind) {
    Range all;
    for (const std::uint64_t word : bits) {
      const double value = NumberOf(word, kind);
      if (!std::isfinite(value)) return std::nullopt;
      all = all ? Union(all, FloatRange{value, value}) : FloatRange{value, value};
    }
    return all;
  }

  Range OfAll(List<ExprId> list, auto& of) const {
    Range all = of(program_.expr_lists[list][0]);
    for (std::uint32_t i = 1; all && i < list.size; ++i)
      all = Union(all, of(program_.expr_lists[list][i]));
    return all;
  }

  Range OfSwizzle(const Swizzle& node, auto& of) const {
    const auto* ref = As<VarRef>(program_, node.base);
    if (!ref) return of(node.base);
    const bool is_place = std::ranges::any_of(program_.inputs, [&](const IoVar& input) {
      return input.builtin == Builtin::kPixelPosition && input.var == ref->var;
    });
    const bool is_xy =
        std::ranges::all_of(node.components.begin(), node.components.begin() + node.count,
                            [](std::uint8_t component) { return component < 2; });
    return is_place && is_xy ? Range(FloatRange{0, kLargestPlace}) : std::nullopt;
  }

  static Range OfBinary(const Binary& node, auto& of) {
    const Range left = of(node.left), right = left ? of(node.right) : std::nullopt;
    if (!left || !right) return std::nullopt;
    switch (node.op) {
      case BinaryOp::kAdd: return Rounded({left->low + right->low, left->high + right->high});
      case BinaryOp::kSub: return Rounded({left->low - right->high, left->high - right->low});
      case BinaryOp::kMul: {
        const auto [low, high] = std::minmax({left->low * right->low, left->low * right->high,
                                              left->high * right->low, left->high * right->high});
        return Rounded({low, high});
      }
      default: return std::nullopt;
    }
  }

  Range OfConversion(const Convert& node, auto& of) const {
    const Scalar from = TypeOf(program_, node.operand).scalar;
    return from == Scalar::kBool ? FloatRange{0, 1} : of(node.operand);
  }

  // min(max(x, low), high) of any x: max(NaN, low) is low in Direct3D.
  static Range Clamped(const Range& low, const Range& high) {
    if (!low || !high) return std::nullopt;
    return FloatRange{std::min(low->low, high->low), high->high};
  }

  // min and max. Of a value that may be anything, min(max(x, low), high) is known as clamp is.
  Range OfExtreme(const IntrinsicCall& node, const Range& a, const Range& b, auto& of) const {
    const bool is_min = node.op == Intrinsic::kMin;
    if (a && b)
      return is_min ? FloatRange{std::min(a->low, b->low), std::min(a->high, b->high)}
                    : FloatRange{std::max(a->low, b->low), std::max(a->high, b->high)};
    if (!a && !b) return std::nullopt;
    const ExprId open = program_.expr_lists[node.arguments][a ? 1 : 0];
    const auto* inner = As<IntrinsicCall>(program_, open);
    if (!inner || inner->op != (is_min ? Intrinsic::kMax : Intrinsic::kMin)) return std::nullopt;
    const auto sides = program_.expr_lists[inner->arguments];
    const Range first = of(sides[0]), other = first ? first : of(sides[1]), &known = a ? a : b;
    if (!other) return std::nullopt;
    return is_min ? Clamped(other, known)
                  : FloatRange{known->low, std::max(known->high, other->high)};
  }

  Range OfIntrinsic(const IntrinsicCall& node, auto& of) const {
    const auto argument = [&](std::size_t number) {
      return of(program_.expr_lists[node.arguments][number]);
    };
    switch (node.op) {
      case Intrinsic::kSaturate:
      case Intrinsic::kStep: return FloatRange{0, 1};  // 0 for NaN
      case Intrinsic::kClamp: return Clamped(argument(1), argument(2));
      case Intrinsic::kMin:
      case Intrinsic::kMax: return OfExtreme(node, argument(0), argument(1), of);
      case Intrinsic::kFloor:
      case Intrinsic::kCeil:
      case Intrinsic::kRound:
      case Intrinsic::kTrunc:
        if (const Range range = argument(0))
          return FloatRange{std::floor(range->low), std::ceil(range->high)};
        return std::nullopt;
      default: return std::nullopt;
    }
  }

  const Program& program_;
};

}  // namespace

std::optional<FloatRange> RangeOf(const Program& program, ExprId expr) {
  return RangeFinder(program).Of(expr);
}

}  // namespace clipc::legalize
