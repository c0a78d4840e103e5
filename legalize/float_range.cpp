// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/float_range.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>

#include "ir/access.h"
#include "ir/evaluate.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"
#include "ir/walk.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// No render target is larger ("Direct3D 11.3 Functional Specification", 21.4: 16384), nor is the
// range of a viewport.
constexpr double kLargestPlace = 32768;
// The operators of an expression that are looked through, so that nested conversions take linear
// time.
constexpr int kMaxDepth = 16;
// A float operation rounds by at most this part of its result, which keeps its sign; a division on
// a graphics processor by a few of these.
constexpr double kRounding = 0x1p-23;
// A float operation may make infinity of what is not below, and 0 of what is smaller than, these.
constexpr double kLargest = 0x1p127, kSmallest = 0x1p-126;

using Range = std::optional<FloatRange>;
using FieldOfVar = std::pair<VarId, std::uint32_t>;

Range Rounded(FloatRange range, int steps = 1) {
  if (std::max(std::abs(range.low), std::abs(range.high)) >= kLargest) return std::nullopt;
  return FloatRange{range.low - std::abs(range.low) * kRounding * steps,
                    range.high + std::abs(range.high) * kRounding * steps, range.may_be_nan};
}

Range Union(const Range& a, const Range& b) {
  if (!a || !b) return std::nullopt;
  return FloatRange{std::min(a->low, b->low), std::max(a->high, b->high),
                    a->may_be_nan || b->may_be_nan};
}

// The results of `op` for the ends of both ranges.
Range OfCorners(const FloatRange& a, const FloatRange& b, auto&& op) {
  const auto [low, high] =
      std::minmax({op(a.low, b.low), op(a.low, b.high), op(a.high, b.low), op(a.high, b.high)});
  return FloatRange{low, high, a.may_be_nan || b.may_be_nan};
}

// Whether a processor may take a value in the range for 0.
bool HasZero(const FloatRange& range) { return range.low < kSmallest && range.high > -kSmallest; }

FloatRange Magnitude(const FloatRange& range) {
  const auto [least, most] = std::minmax({std::abs(range.low), std::abs(range.high)});
  return {HasZero(range) ? 0 : least, most, range.may_be_nan};
}

// All that an int or uint can be; std::nullopt for every other scalar.
Range AllOf(Scalar kind) {
  if (kind == Scalar::kInt) return FloatRange{-0x1p31, 0x1p31};
  if (kind == Scalar::kUint) return FloatRange{0, 0x1p32};
  return std::nullopt;
}

class RangeFinder {
 public:
  using OfLocal = std::function<Range(VarId)>;
  using OfField = std::function<ExprId(const FieldRef&)>;

  RangeFinder(const Program& program, const OfLocal& of_local, const OfField& of_field)
      : program_(program), of_local_(of_local), of_field_(of_field) {}

  Range Of(ExprId expr, int depth = 0) const {
    if (depth == 0 || As<Literal>(program_, expr) || As<VarRef>(program_, expr)) {
      if (const auto bits = ConstantBits(program_, expr))
        return OfConstant(*bits, TypeOf(program_, expr).scalar);
    }
    const Type& type = TypeOf(program_, expr);
    // What has fewer digits may be as small as 65504.
    const bool is_float = type.scalar == Scalar::kFloat || type.scalar == Scalar::kDouble;
    const Range all = AllOf(type.scalar);
    if (!type.IsNumeric() || (!is_float && !all)) return std::nullopt;
    const Range range = depth < kMaxDepth ? OfNode(expr, depth) : std::nullopt;
    if (is_float) return range;
    // An integer that leaves its type begins anew at the other end.
    return range && range->low >= all->low && range->high <= all->high ? range : all;
  }

 private:
  Range OfNode(ExprId expr, int depth) const {
    const auto of = [&](ExprId operand) { return Of(operand, depth + 1); };
    return Visit(
        Overloaded{
            [&](const VarRef& node) { return of_local_(node.var); },
            [&](const FieldRef& node) {
              const ExprId value = of_field_(node);
              return value ? of(value) : std::nullopt;
            },
            [&](const Swizzle& node) {
              return OfComponents(node.base, {node.components.data(), node.count}, depth + 1);
            },
            [&](const Unary& node) {
              const auto range = node.op == UnaryOp::kNegate ? of(node.operand) : std::nullopt;
              return range ? Range({-range->high, -range->low, range->may_be_nan}) : std::nullopt;
            },
            [&](const Binary& node) { return OfBinary(expr, node, of); },
            [&](const Convert& node) { return OfConversion(expr, node, of); },
            [&](const Splat& node) { return of(node.operand); },
            [&](const Construct& node) { return OfAll(node.arguments, of); },
            [&](const Conditional& node) { return Union(of(node.when_true), of(node.when_false)); },
            [&](const IntrinsicCall& node) { return OfIntrinsic(node, of); },
            [](const auto&) { return Range(); },
        },
        program_.exprs[expr].node);
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

  // Of these components of a vector or scalar.
  Range OfComponents(ExprId expr, std::span<const std::uint8_t> components, int depth) const {
    if (depth >= kMaxDepth) return std::nullopt;
    const auto of_whole = [&] { return Of(expr, depth); };
    return Visit(Overloaded{
                     [&](const VarRef& node) {
                       if (!IsPlace(node.var)) return of_whole();
                       const bool is_xy = std::ranges::all_of(
                           components, [](std::uint8_t component) { return component < 2; });
                       return is_xy ? Range(FloatRange{0, kLargestPlace}) : std::nullopt;
                     },
                     [&](const FieldRef& node) {
                       const ExprId value = of_field_(node);
                       return value ? OfComponents(value, components, depth + 1) : std::nullopt;
                     },
                     [&](const Construct& node) { return OfParts(node, components, depth + 1); },
                     [&](const auto&) { return of_whole(); },
                 },
                 program_.exprs[expr].node);
  }

  // Of these components of a vector that is put together.
  Range OfParts(const Construct& node, std::span<const std::uint8_t> components, int depth) const {
    Range all;
    for (const std::uint8_t component : components) {
      std::uint32_t argument = 0, at = component;
      const auto size = [&] {
        const Type& type = TypeOf(program_, program_.expr_lists[node.arguments][argument]);
        return std::uint32_t{type.rows} * type.columns;
      };
      for (; argument + 1 < node.arguments.size && at >= size(); ++argument) at -= size();
      const auto part = static_cast<std::uint8_t>(at);
      const Range range =
          OfComponents(program_.expr_lists[node.arguments][argument], {&part, 1}, depth);
      all = component == components[0] ? range : Union(all, range);
      if (!all) return all;
    }
    return all;
  }

  bool IsPlace(VarId var) const {
    return std::ranges::any_of(program_.inputs, [&](const IoVar& input) {
      return input.builtin == Builtin::kPixelPosition && input.var == var;
    });
  }

  Range OfBinary(ExprId expr, const Binary& node, auto& of) const {
    const bool is_float = IsFloat(TypeOf(program_, expr).scalar);
    const Range left = of(node.left), right = left ? of(node.right) : std::nullopt;
    if (!left || !right) return std::nullopt;
    const bool may_be_nan = left->may_be_nan || right->may_be_nan;
    switch (node.op) {
      case BinaryOp::kAdd:
        return Rounded({left->low + right->low, left->high + right->high, may_be_nan});
      case BinaryOp::kSub:
        return Rounded({left->low - right->high, left->high - right->low, may_be_nan});
      case BinaryOp::kMul: {
        const Range product = OfCorners(*left, *right, std::multiplies<>());
        return Rounded(*product);
      }
      case BinaryOp::kDiv: {
        // An integer is divided by what is not 0, or has no meaning.
        if (!is_float || HasZero(*right)) return std::nullopt;
        const Range quotient = OfCorners(*left, *right, std::divides<>());
        return Rounded(*quotient, 4);
      }
      case BinaryOp::kMod: return is_float ? std::nullopt : Remainder(*left, *right);
      case BinaryOp::kBitAnd: {
        // At most the least of those that have no sign.
        const Range& mask = right->low >= 0 ? right : left;
        if (mask->low < 0) return std::nullopt;
        const double other = left->low >= 0 ? left->high : mask->high;
        return FloatRange{0, std::min(mask->high, other)};
      }
      default: return std::nullopt;
    }
  }

  // Of x % y, which has the sign of x and is smaller than y.
  static Range Remainder(const FloatRange& left, const FloatRange& right) {
    if (HasZero(right)) return std::nullopt;
    const double most = Magnitude(right).high;
    return FloatRange{left.low < 0 ? -most : 0, left.high > 0 ? most : 0};
  }

  // Of a conversion, which truncates where it gives an integer. Of does the rest where the value
  // does not fit.
  Range OfConversion(ExprId expr, const Convert& node, auto& of) const {
    const Scalar from = TypeOf(program_, node.operand).scalar;
    if (from == Scalar::kBool) return FloatRange{0, 1};
    const Range range = of(node.operand);
    if (!range || IsFloat(TypeOf(program_, expr).scalar)) return range ? Rounded(*range) : range;
    return range->may_be_nan ? Union(range, FloatRange{0, 0}) : range;
  }

  // min(max(x, low), high) of any x: max(NaN, low) is low in Direct3D.
  static Range Clamped(const Range& low, const Range& high) {
    if (!low || !high || low->may_be_nan || high->may_be_nan) return std::nullopt;
    return FloatRange{std::min(low->low, high->low), high->high};
  }

  // min and max. Of a value that may be anything, min(max(x, low), high) is known as clamp is.
  Range OfExtreme(const IntrinsicCall& node, const Range& a, const Range& b, auto& of) const {
    const bool is_min = node.op == Intrinsic::kMin;
    if (a && b) {
      const bool may_be_nan = a->may_be_nan || b->may_be_nan;
      return is_min ? FloatRange{std::min(a->low, b->low), std::min(a->high, b->high), may_be_nan}
                    : FloatRange{std::max(a->low, b->low), std::max(a->high, b->high), may_be_nan};
    }
    const Range& known = a ? a : b;
    if (!known || known->may_be_nan) return std::nullopt;
    const ExprId open = program_.expr_lists[node.arguments][a ? 1 : 0];
    const auto* inner = As<IntrinsicCall>(program_, open);
    if (!inner || inner->op != (is_min ? Intrinsic::kMax : Intrinsic::kMin)) return std::nullopt;
    const auto sides = program_.expr_lists[inner->arguments];
    const Range first = of(sides[0]), other = first ? first : of(sides[1]);
    if (!other || other->may_be_nan) return std::nullopt;
    return is_min ? Clamped(other, known)
                  : FloatRange{known->low, std::max(known->high, other->high)};
  }

  Range OfIntrinsic(const IntrinsicCall& node, auto& of) const {
    const auto argument = [&](std::size_t number) {
      return of(program_.expr_lists[node.arguments][number]);
    };
    switch (node.op) {
      case Intrinsic::kSaturate:
      case Intrinsic::kStep: return FloatRange{0, 1};        // 0 for NaN
      case Intrinsic::kFrac: return FloatRange{0, 1, true};  // of infinity
      case Intrinsic::kClamp: return Clamped(argument(1), argument(2));
      case Intrinsic::kMin:
      case Intrinsic::kMax: return OfExtreme(node, argument(0), argument(1), of);
      case Intrinsic::kFmod: return OfFmod(argument(0), argument(1));
      case Intrinsic::kAbs:
        if (const Range range = argument(0)) return Magnitude(*range);
        return std::nullopt;
      case Intrinsic::kFloor:
      case Intrinsic::kCeil:
      case Intrinsic::kRound:
      case Intrinsic::kTrunc:
        if (const Range range = argument(0))
          return FloatRange{std::floor(range->low), std::ceil(range->high), range->may_be_nan};
        return std::nullopt;
      default: return std::nullopt;
    }
  }

  // Of x - y * trunc(x / y), where the quotient may be rounded to the next integer.
  static Range OfFmod(const Range& x, const Range& y) {
    if (!x || !y || HasZero(*y)) return std::nullopt;
    const FloatRange top = Magnitude(*x), divisor = Magnitude(*y);
    if (top.high >= kLargest * std::min(1.0, divisor.low)) return std::nullopt;
    const double most = divisor.high + 16 * kRounding * top.high;
    return FloatRange{-most, most, x->may_be_nan || y->may_be_nan};
  }

  const Program& program_;
  const OfLocal& of_local_;
  const OfField& of_field_;
};

// The field of a variable that the path lies in; std::nullopt where it starts with no field.
std::optional<FieldOfVar> FieldOf(const Program& program, ExprId path) {
  for (; path; path = WholeOf(program, path)) {
    const auto* field = As<FieldRef>(program, path);
    const auto* ref = field ? As<VarRef>(program, field->base) : nullptr;
    if (ref) return FieldOfVar(ref->var, field->field);
  }
  return std::nullopt;
}

// The amount by which the step of a loop changes its variable, below 0 where it counts down.
std::optional<double> StepOf(const Program& program, ExprId step) {
  if (const auto* unary = As<Unary>(program, step))
    return unary->op == UnaryOp::kPreIncrement || unary->op == UnaryOp::kPostIncrement ? 1 : -1;
  const auto* assign = As<Assign>(program, step);
  if (!assign || (assign->op != BinaryOp::kAdd && assign->op != BinaryOp::kSub))
    return std::nullopt;
  const auto bits = ConstantBits(program, assign->value);
  if (!bits || bits->size() != 1) return std::nullopt;
  const double by = NumberOf((*bits)[0], TypeOf(program, assign->value).scalar);
  return assign->op == BinaryOp::kAdd ? by : -by;
}

}  // namespace

Range FloatRanges::Of(ExprId expr) {
  const RangeFinder::OfLocal of_local = [&](VarId var) -> Range {
    return IsKnown(var) ? locals_[var.index] : std::nullopt;
  };
  const RangeFinder::OfField of_field = [&](const FieldRef& node) { return ValueOf(node); };
  return RangeFinder(program_, of_local, of_field).Of(expr);
}

// Whether the variable is one that declarations tell of.
bool FloatRanges::IsKnown(VarId var) {
  if (program_.vars[var].storage != Storage::kLocal) return false;
  if (!has_locals_ && !MayTell(var)) return false;
  if (!has_locals_) FindLocals();
  return var.index < locals_.size();
}

// Whether the value that the variable is declared with may have bounds, as a short look tells. What
// a function or an object gives has none.
bool FloatRanges::MayTell(VarId var) {
  if (may_tell_.empty()) {
    may_tell_.resize(program_.vars.size());
    program_.stmts.ForEach([&](StmtId, const Stmt& stmt) {
      const auto* declare = std::get_if<Declare>(&stmt.node);
      ExprId init = declare ? declare->init : ExprId{};
      while (const auto* part = init ? As<Swizzle>(program_, init) : nullptr) init = part->base;
      if (init && !As<Call>(program_, init) && !As<ObjectCall>(program_, init))
        may_tell_[declare->var.index] = true;
    });
  }
  return var.index >= may_tell_.size() || may_tell_[var.index];
}

// Declarations are found in the order of the text, so that the variables in their values are known.
void FloatRanges::FindLocals() {
  has_locals_ = true;
  locals_.resize(program_.vars.size());
  values_.resize(program_.vars.size());
  std::vector<std::uint32_t> writes(program_.vars.size());
  ForEachLiveExpr(program_, [&](ExprId expr) {
    ForEachWrite(program_, expr, [&](ExprId target) {
      if (const auto field = FieldOf(program_, target)) {
        written_fields_.push_back(*field);
      } else if (const VarId root = RootOf(program_, target)) {
        ++writes[root.index];
      }
    });
  });
  std::ranges::sort(written_fields_);
  const auto on_declaration = [&](const Declare& declare) {
    if (!declare.init || writes[declare.var.index] != 0) return;
    if (program_.types[program_.vars[declare.var].type].IsNumeric()) {
      locals_[declare.var.index] = Of(declare.init);
    } else if (As<Construct>(program_, declare.init)) {
      values_[declare.var.index] = declare.init;
    }
  };
  for (const FunctionId id : program_.functions.ids()) {
    ForEachStmt(program_, program_.functions[id].body, [&](StmtId stmt) {
      if (const auto* loop = As<For>(program_, stmt)) FindCounter(*loop, writes);
      if (const auto* declare = As<Declare>(program_, stmt)) on_declaration(*declare);
    });
  }
}

// What the field has from its variable's declaration on; none where it may change.
ExprId FloatRanges::ValueOf(const FieldRef& node) {
  const VarId var = RootOf(program_, node.base);
  if (!var || !IsKnown(var) || !As<VarRef>(program_, node.base)) return {};
  const auto* value = As<Construct>(program_, values_[var.index]);
  const bool is_settled = value &&
                          program_.types[program_.vars[var].type].kind == TypeKind::kStruct &&
                          !std::ranges::binary_search(written_fields_, FieldOfVar(var, node.field));
  return is_settled ? program_.expr_lists[value->arguments][node.field] : ExprId{};
}

// The variable of `for (int i = first; i < last; i++)` that only the step changes.
void FloatRanges::FindCounter(const For& loop, const std::vector<std::uint32_t>& writes) {
  if (loop.init.size != 1 || !loop.condition || !loop.step) return;
  const auto* declare = As<Declare>(program_, program_.stmt_lists[loop.init][0]);
  const auto* condition = As<Binary>(program_, loop.condition);
  if (!declare || !declare->init || !condition || writes[declare->var.index] != 1) return;
  const auto counts = [&](ExprId expr) {
    const auto* ref = As<VarRef>(program_, expr);
    return ref && ref->var == declare->var;
  };
  bool is_counted = false;
  ForEachWrite(program_, loop.step, [&](ExprId target) { is_counted = counts(target); });
  const auto step = is_counted ? StepOf(program_, loop.step) : std::nullopt;
  if (!step || !counts(condition->left)) return;
  const bool is_up = condition->op == BinaryOp::kLess || condition->op == BinaryOp::kLessEqual;
  const bool is_down =
      condition->op == BinaryOp::kGreater || condition->op == BinaryOp::kGreaterEqual;
  if (!(is_up && *step > 0) && !(is_down && *step < 0)) return;
  const Range first = Of(declare->init), last = Of(condition->right);
  if (!first || !last || first->may_be_nan || last->may_be_nan) return;
  // After its last step the variable is beyond the end.
  const FloatRange range = is_up ? FloatRange{first->low, std::max(first->high, last->high + *step)}
                                 : FloatRange{std::min(first->low, last->low + *step), first->high};
  const Range all = AllOf(program_.types[program_.vars[declare->var].type].scalar);
  if (all && range.low >= all->low && range.high < all->high) locals_[declare->var.index] = range;
}

}  // namespace clipc::legalize
